package robotran.ui.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue

/** Keeps the world while it is changed; null while it is not. */
class WorldEditHolder(private val bench: Bench) {
    var state: WorldEditState? by mutableStateOf(null)
        private set

    fun handle(event: WorldEditEvent) {
        when (event) {
            WorldEditEvent.EditorOpened -> state = WorldEditState(bench.project.world)
            WorldEditEvent.EditorClosed -> close()
        }
    }

    private fun close() {
        val world = state?.world ?: return
        state = null
        bench.changeWorld(world)
    }
}
