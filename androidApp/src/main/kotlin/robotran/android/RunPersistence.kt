package robotran.android

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import kotlinx.coroutines.yield
import robotran.documents.projectFile
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import java.io.File
import java.io.IOException

/**
 * The run that was watched when the app went out of sight. Android may end the process then; the same inputs make the
 * same run again, so [file] holds them with the programs and the world they belong to.
 */
internal class RunPersistence(private val file: File) {
    /** Keeps the run of [workshop], if there is one that can be made again. */
    suspend fun keep(workshop: Workshop) {
        val state = workshop.state
        // A replay runs the programs as they are written now.
        val canBeMadeAgain = !state.untouched && !state.changed
        val replay = workshop.replay
        withContext(Dispatchers.IO) {
            val bytes = if (canBeMadeAgain && replay.inputs.isNotEmpty()) projectFile(replay) else null
            try {
                if (bytes == null) file.delete() else file.writeBytes(bytes)
            } catch (_: IOException) {
                file.delete()
            }
        }
    }

    /**
     * Makes the run again as far as [time], in milliseconds, and lets it stand still there, if [workshop] still has the
     * programs and the world it belongs to, and if nobody has to wait for long.
     */
    suspend fun restore(workshop: Workshop, time: Long) {
        if (time !in 1..LONGEST) return
        val replay = withContext(Dispatchers.IO) { read() } ?: return
        if (replay.withoutRun() != workshop.project.withoutRun()) return
        workshop.openProject(replay)
        workshop.readPrograms()
        workshop.handle(RunEvent.RecordingPlayed)
        for (done in 0 until time step PART) {
            workshop.advance(minOf(PART, time - done).toInt())
            yield()
        }
        workshop.handle(RunEvent.PausePressed)
    }

    /** What belongs to the work itself. */
    private fun Project.withoutRun() = copy(robots = robots.map { it.copy(firstProgram = 0) }, inputs = emptyList())

    private fun read(): Project? = try {
        (readProject(file.readBytes()) as? ProjectFileResult.Loaded)?.project
    } catch (_: IOException) {
        null
    }

    private companion object {
        /** Ten minutes of a run, in milliseconds: they take a few seconds. */
        const val LONGEST = 600_000L

        /** What is made again at once, in milliseconds. */
        const val PART = 1_000L
    }
}
