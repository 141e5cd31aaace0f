package robotran.simulation.physics

import robotran.world.geometry.Trigonometry

/** Rigid bodies seen from above, with their trigonometry; bit for bit the same on every target. */
interface PhysicsEngine {
    val trigonometry: Trigonometry

    /** A new, empty world. */
    fun createWorld(settings: PhysicsSettings): PhysicsWorld
}

/**
 * The physics of this platform. Immediate on the JVM and Android; in the browser it loads the physics module first, and
 * throws if that fails.
 */
expect suspend fun loadPhysicsEngine(): PhysicsEngine
