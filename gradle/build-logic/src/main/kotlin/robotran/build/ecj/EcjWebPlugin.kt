package robotran.build.ecj

import robotran.build.teavm.WebFilesPlugin

/**
 * For every module that links `shared/java-compiler` into a wasm test or executable: `loadJavaCompiler()` imports
 * `ecj.mjs`.
 */
class EcjWebPlugin : WebFilesPlugin(":shared:ecj")
