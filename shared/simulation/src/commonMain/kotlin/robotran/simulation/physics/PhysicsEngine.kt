package robotran.simulation.physics

import robotran.world.geometry.Trigonometry

/** Rigid bodies seen from above, and the trigonometry that goes with them; the same to the last bit on every target. */
interface PhysicsEngine {
    val trigonometry: Trigonometry

    /** A new world with nothing in it. */
    fun createWorld(settings: PhysicsSettings): PhysicsWorld
}

/**
 * The physics of this platform: at once on the JVM and Android; in the browser it loads the physics module first, and
 * throws if it cannot.
 */
expect suspend fun loadPhysicsEngine(): PhysicsEngine
