package robotran.ui.sheet

import androidx.compose.ui.graphics.ImageBitmap
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import kotlinx.coroutines.yield
import robotran.world.RobotLoad
import robotran.world.Session
import robotran.world.SessionState
import robotran.world.World
import robotran.world.physics.PhysicsEngine
import robotran.world.physics.loadPhysicsEngine

/**
 * Small pictures of worlds before anything has happened there, each drawn once and one after the other, so that the screen goes on meanwhile.
 *
 * @param pixels how wide they are.
 */
internal class SheetPictures(private val pixels: Int) {
    private val drawing = Mutex()
    private val drawn = mutableMapOf<String, ImageBitmap>()
    private var colours: SheetColours? = null

    /** The picture of the world known as [key] if it has been drawn in these [colours]. */
    fun ready(key: String, colours: SheetColours): ImageBitmap? = drawn[key].takeIf { this.colours == colours }

    /** The picture of [world], which is known as [key], drawn if it was not. */
    suspend fun of(key: String, world: World, colours: SheetColours): ImageBitmap = drawing.withLock {
        if (colours != this.colours || drawn.size >= MOST) drawn.clear()
        this.colours = colours
        drawn[key] ?: draw(world, colours).also { drawn[key] = it }
    }

    private suspend fun draw(world: World, colours: SheetColours): ImageBitmap {
        yield()
        val engine = physics ?: loadPhysicsEngine().also { physics = it }
        return withContext(Dispatchers.Default) { renderSheet(world, atStart(world, engine), pixels, colours = colours) }
    }

    private fun atStart(world: World, engine: PhysicsEngine): SessionState {
        val session = Session(world, emptyList<RobotLoad>(), engine)
        return session.state.also { session.close() }
    }

    private companion object {
        /** So many are remembered at most. */
        const val MOST = 120
        var physics: PhysicsEngine? = null
    }
}
