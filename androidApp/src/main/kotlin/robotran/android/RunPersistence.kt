package robotran.android

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import kotlinx.coroutines.yield
import robotran.documents.StoreResult
import robotran.documents.files.writeSafely
import robotran.documents.projectFile
import robotran.language.Language
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import java.io.File
import java.io.IOException

/**
 * Saves the run on the screen when the app is hidden, since Android may then end the process. [file] holds the
 * programs, the world and the inputs, which reproduce the run.
 */
internal class RunPersistence(private val file: File) {
    /** Saves the run of [workshop] if it can be reproduced. */
    suspend fun keep(workshop: Workshop) {
        val state = workshop.state
        val replay = workshop.replay
        // A replay runs the current programs, and none that were sent to run at once.
        val isReproducible = !state.untouched && !state.changed && replay.inputs.size == workshop.inputs.size
        withContext(Dispatchers.IO) {
            val bytes = if (isReproducible && replay.inputs.isNotEmpty()) projectFile(replay) else null
            val isKept = bytes != null && writeSafely(file.toPath(), bytes) == StoreResult.Done
            // An older run is none of this program.
            if (!isKept) file.delete()
        }
    }

    /**
     * Repeats the run up to [time], in milliseconds, and pauses there. Does so only if [workshop] still has the same
     * programs and world, and if the replay is short.
     */
    suspend fun restore(workshop: Workshop, time: Long) {
        if (time !in 1..LONGEST) return
        val replay = withContext(Dispatchers.IO) { read() } ?: return
        if (replay.withoutRun() != workshop.project.withoutRun()) return
        workshop.services.editor.openProject(replay)
        workshop.compilePrograms()
        workshop.handle(RunEvent.RecordingPlayed)
        for (done in 0 until time step PART) {
            workshop.advance(minOf(PART, time - done).toInt())
            yield()
        }
        workshop.handle(RunEvent.PausePressed)
    }

    /** The project without the state of the run. */
    private fun Project.withoutRun() = copy(robots = robots.map { it.copy(firstProgram = 0) }, inputs = emptyList())

    private fun read(): Project? = try {
        (readProject(file.readBytes(), Language.ENGLISH) as? ProjectFileResult.Success)?.project
    } catch (_: IOException) {
        null
    }

    private companion object {
        /** Ten minutes of a run, in milliseconds: the replay takes a few seconds. */
        const val LONGEST = 600_000L

        /** The step size of the replay, in milliseconds. */
        const val PART = 1_000L
    }
}
