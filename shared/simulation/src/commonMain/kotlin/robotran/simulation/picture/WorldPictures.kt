package robotran.simulation.picture

import robotran.simulation.state.SessionState
import robotran.world.World

/** Renders a world to image files. */
interface WorldPictures {
    /** A PNG file of [world] in [state]. */
    fun png(world: World, state: SessionState): ByteArray

    /** The same as SVG text, identical on every platform. */
    fun svg(world: World, state: SessionState): String

    /** Draws [world] again and again, as frames that are at most [maxSide] pixels wide and high. */
    fun frames(world: World, maxSide: Int): WorldFrames
}

/** The frames of an animation of one world. Belongs to one thread at a time. */
interface WorldFrames {
    /** Pixels. */
    val width: Int

    /** Pixels. */
    val height: Int

    /** Draws the world in [state] into [pixels]: rows from the top, `0xAARRGGBB`, [width] times [height] of them. */
    fun draw(state: SessionState, pixels: IntArray)
}

/** Empty images, for tests that save none. */
object NoWorldPictures : WorldPictures {
    override fun png(world: World, state: SessionState): ByteArray = ByteArray(0)

    override fun svg(world: World, state: SessionState): String = ""

    override fun frames(world: World, maxSide: Int): WorldFrames = object : WorldFrames {
        override val width = 1
        override val height = 1

        override fun draw(state: SessionState, pixels: IntArray) = pixels.fill(0)
    }
}
