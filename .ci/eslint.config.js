// The rules of the page's scripts, beside those that eslint recommends.
import js from "@eslint/js";
import globals from "globals";

export default [
  js.configs.recommended,
  {
    files: ["support/page/web/*.js", "tests/project/page/*.js"],
    languageOptions: { globals: globals.browser },
    rules: {
      "no-restricted-syntax": ["error", {
        selector: "ExportNamedDeclaration > VariableDeclaration[kind!=const]",
        message: "Only this module may change it: export a constant, or a function.",
      }],
    },
  },
];
