// Runs the Khronos validator on files; prints every error and warning, fails on errors.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
const fs = require('fs');
const path = require('path');
const validator = require('gltf-validator');

async function check(file) {
  const beside = async (uri) => new Uint8Array(fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri))));
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {maxIssues: 50, externalResourceFunction: beside});
  const {numErrors, numWarnings} = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${report.info.totalTriangleCount} triangles`);
  for (const issue of report.issues.messages.filter(message => message.severity < 2))
    console.log(`  ${issue.code} at ${issue.pointer}: ${issue.message}`);
  return numErrors;
}

(async () => {
  let errors = 0;
  for (const file of process.argv.slice(2))
    errors += await check(file);
  console.log(`gltf-validator ${validator.version()}: ${process.argv.length - 2} files, ${errors} errors`);
  process.exit(errors === 0 && process.argv.length > 2 ? 0 : 1);
})();
