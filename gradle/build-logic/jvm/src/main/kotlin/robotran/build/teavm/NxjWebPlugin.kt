package robotran.build.teavm

/** For a module whose wasm tests use `NxjLibrary.load()`, which imports `nxj-library.mjs`, but not the Java compiler. */
class NxjWebPlugin : WebFilesPlugin(":shared:nxj-library")
