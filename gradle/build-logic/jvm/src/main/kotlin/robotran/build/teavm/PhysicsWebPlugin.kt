package robotran.build.teavm

/**
 * For every module that links `shared/simulation` into a wasm test or executable: `loadPhysicsEngine()` imports
 * `physics.mjs`.
 */
class PhysicsWebPlugin : WebFilesPlugin(":shared:physics")
