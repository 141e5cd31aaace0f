package robotran.ui.sheet

import androidx.compose.ui.graphics.ImageBitmap
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import kotlinx.coroutines.yield
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.pressRun
import robotran.simulation.state.SessionState
import robotran.world.World
import kotlin.concurrent.Volatile

/**
 * Thumbnails of worlds, before or after a run of programs. Each is drawn once, one at a time, in the background, and
 * at about its display size, so that thin lines keep their width.
 */
class SheetPictures {
    private val drawing = Mutex()

    /** Replaced as a whole, since [ready] reads it on the event thread while [of] may end on another one. */
    @Volatile
    private var cache = Cache(null, emptyMap())

    /** The thumbnail of the world [key] in these [colours] for [room], or one for another size until it is drawn. */
    fun ready(key: String, colours: SheetColours, room: PictureBounds): ImageBitmap? {
        val (cached, pictures) = cache
        if (cached != colours) return null
        return pictures[key to room.pixels] ?: pictures.entries.firstOrNull { it.key.first == key }?.value
    }

    /**
     * The thumbnail of [world] with the cache key [key] for [room], after a run of the programs in [loads], if any;
     * changed by [shown]; drawn on first use.
     */
    suspend fun of(
        key: String,
        world: World,
        colours: SheetColours,
        room: PictureBounds,
        shown: (SessionState) -> SessionState = { it },
        loads: suspend () -> List<RobotProgramSet> = { emptyList() },
    ): ImageBitmap = drawing.withLock {
        val kept = cache.takeIf { it.colours == colours && it.pictures.size < MAX } ?: Cache(colours, emptyMap())
        kept.pictures[key to room.pixels] ?: draw(world, { shown(stateOf(world, loads(), it)) }, colours, room).also {
            cache = Cache(colours, kept.pictures + ((key to room.pixels) to it))
        }
    }

    private suspend fun draw(
        world: World,
        state: suspend (PhysicsEngine) -> SessionState,
        colours: SheetColours,
        room: PictureBounds,
    ): ImageBitmap {
        yield()
        val engine = physics ?: loadPhysicsEngine().also { physics = it }
        val width = room.widthFor(world.paper)
        return withContext(Dispatchers.Default) {
            renderSheet(world, state(engine), width, colours = colours, density = room.density)
        }
    }

    private suspend fun stateOf(world: World, loads: List<RobotProgramSet>, engine: PhysicsEngine): SessionState {
        val session = Session(world, loads, engine, Language.ENGLISH)
        try {
            if (loads.isNotEmpty()) session.runInParts()
            return session.state
        } finally {
            session.close()
        }
    }

    /** Runs the first program to its end or a time limit, in small steps. */
    private suspend fun Session.runInParts() {
        pressRun()
        repeat(MAX_PARTS) {
            advance(PART)
            if (state.brick.run !is RunState.Running) return
            yield()
        }
    }

    private data class Cache(val colours: SheetColours?, val pictures: Map<Pair<String, Int>, ImageBitmap>)

    private companion object {
        /** The max number of cached thumbnails. */
        const val MAX = 120

        /** Milliseconds of virtual time. */
        const val PART = 250
        const val MAX_PARTS = 160
        var physics: PhysicsEngine? = null
    }
}
