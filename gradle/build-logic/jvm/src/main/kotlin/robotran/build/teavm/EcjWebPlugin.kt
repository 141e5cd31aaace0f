package robotran.build.teavm

/**
 * For every module that links `shared/java-compiler` into a wasm test or executable: `loadJavaCompiler()` imports
 * `ecj.mjs`.
 */
class EcjWebPlugin : WebFilesPlugin(":shared:ecj")
