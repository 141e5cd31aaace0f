package robotran.simulation.picture

import robotran.simulation.state.SessionState
import robotran.world.World

/** Renders a world to image files. */
interface WorldPictures {
    /** A PNG file of [world] in [state]. */
    fun png(world: World, state: SessionState): ByteArray

    /** The same as SVG text, identical on every platform. */
    fun svg(world: World, state: SessionState): String
}

/** Empty images, for tests that save none. */
object NoWorldPictures : WorldPictures {
    override fun png(world: World, state: SessionState): ByteArray = ByteArray(0)

    override fun svg(world: World, state: SessionState): String = ""
}
