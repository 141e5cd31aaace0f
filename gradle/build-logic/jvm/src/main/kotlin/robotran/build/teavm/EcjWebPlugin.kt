package robotran.build.teavm

/**
 * For every module that links `shared/java-compiler` into a wasm test or executable: `loadJavaCompiler()` imports
 * `ecj.mjs`, and `NxjLibrary.load()` imports `nxj-library.mjs`.
 */
class EcjWebPlugin : WebFilesPlugin(":shared:ecj", ":shared:nxj-library")
