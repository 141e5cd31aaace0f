package robotran.ui.learning

import androidx.compose.ui.graphics.ImageBitmap
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import kotlinx.coroutines.yield
import robotran.learning.GalleryWorld
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.renderSheet
import robotran.world.RobotLoad
import robotran.world.Session
import robotran.world.SessionState
import robotran.world.World
import robotran.world.physics.PhysicsEngine
import robotran.world.physics.loadPhysicsEngine

/** Small pictures of the gallery's worlds, each drawn once and one after the other, so that the screen goes on meanwhile. */
internal object WorldPictures {
    private val drawing = Mutex()
    private val drawn = mutableMapOf<String, ImageBitmap>()
    private var colours: SheetColours? = null
    private var physics: PhysicsEngine? = null

    /** The picture of [world] if it has been drawn in these [colours]. */
    fun ready(world: GalleryWorld, colours: SheetColours): ImageBitmap? = drawn[world.name].takeIf { this.colours == colours }

    /** The picture of [world], drawn if it was not. */
    suspend fun of(world: GalleryWorld, colours: SheetColours): ImageBitmap = drawing.withLock {
        if (colours != this.colours) drawn.clear()
        this.colours = colours
        drawn[world.name] ?: draw(world.plainWorld, colours).also { drawn[world.name] = it }
    }

    private suspend fun draw(world: World, colours: SheetColours): ImageBitmap {
        yield()
        val engine = physics ?: loadPhysicsEngine().also { physics = it }
        return withContext(Dispatchers.Default) { renderSheet(world, atStart(world, engine), PIXELS, colours = colours) }
    }

    private fun atStart(world: World, engine: PhysicsEngine): SessionState {
        val session = Session(world, emptyList<RobotLoad>(), engine)
        return session.state.also { session.close() }
    }

    /** Enough for a card on a screen of two pixels a dp. */
    private const val PIXELS = 560
}
