package robotran.ui.platform

import kotlinx.coroutines.runBlocking
import robotran.documents.ProjectRepository
import robotran.documents.SaveResult
import robotran.documents.SavedProject
import robotran.documents.SavedProjectResult
import robotran.projects.Project
import robotran.world.file.BuiltInWorlds
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** A process that autosaves a changing project as fast as it can and reports each stored copy. */
internal class AutosavingProcess private constructor(private val process: Process) {
    private val lines = process.inputStream.bufferedReader()

    /** The number of copies reported so far. */
    var described = 0
        private set

    /** Waits until this number of copies is reported; returns the number. */
    fun awaitCopies(count: Int): Int {
        while (described < count) {
            check(lines.readLine() != null) { "the process has ended" }
            described++
        }
        return described
    }

    /** Like `kill -9`. Process.destroy would close the stream with the last reports. */
    fun kill() {
        process.toHandle().destroyForcibly()
        check(process.waitFor(WAIT_SECONDS, TimeUnit.SECONDS)) { "it lives on" }
        described += lines.readLines().count { it == TOLD }
    }

    companion object {
        const val TOLD = "kept"
        private const val WAIT_SECONDS = 20L

        fun start(folder: Path): AutosavingProcess {
            val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
            val command =
                listOf(
                    java,
                    "-cp",
                    System.getProperty("java.class.path"),
                    "robotran.ui.platform.AutosavingMain",
                    folder.toString(),
                )
            return AutosavingProcess(ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start())
        }
    }
}

internal fun workFor(name: String) = SavedProject("one", name, 1_000, Project(BuiltInWorlds.plain))

/** The main class of a [AutosavingProcess]. */
internal object AutosavingMain {
    @JvmStatic
    fun main(arguments: Array<String>): Unit = runBlocking {
        val shelf = ProjectRepository(FolderKeyValueStore(Path.of(arguments.single())))
        checkNotNull(shelf.claim("one"))
        var number = (shelf.read("one") as? SavedProjectResult.Found)?.work?.name?.toInt() ?: 0
        while (true) {
            number++
            check(shelf.save(workFor(number.toString())) == SaveResult.Saved)
            println(AutosavingProcess.TOLD)
            System.out.flush()
        }
    }
}
