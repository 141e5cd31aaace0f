package robotran.workshop.documents

import kotlinx.coroutines.runBlocking
import robotran.documents.StoreResult
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.writeProject
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.FilePicker
import robotran.workshop.platform.FixedClock
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.MemoryStore
import robotran.workshop.platform.NoWindowMemory
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenRequests
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.OpeningMarks
import robotran.workshop.platform.Saving
import robotran.workshop.platform.Sharing
import robotran.workshop.platform.WindowMemory
import robotran.workshop.sound.NoLoudSpeaker
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.ProjectListEntry
import robotran.world.file.BuiltInWorlds

/** Files in memory. [chosen] is the user's choice to open, [location] the location to save to; null if cancelled. */
internal class MemoryFilePicker : FilePicker {
    val disk = mutableMapOf<String, ByteArray>()
    var chosen: List<OpenedFile> = emptyList()
    var location: String? = null
    var full = false
    var suggestion = ""
        private set

    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> = chosen

    override suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving {
        suggestion = name
        val location = location ?: return Saving.Cancelled
        return write(location, location.substringAfterLast('/'), bytes)
    }

    override suspend fun write(location: String, name: String, bytes: ByteArray): Saving {
        if (full) return Saving.Failed("", isFull = true)
        disk[location] = bytes
        return Saving.Saved(name, location)
    }

    override suspend fun read(location: String): ByteArray? = disk[location]

    /** The time of every file. */
    var changed: Long? = null

    override suspend fun changedAt(location: String): Long? = changed
}

/** Marks that outlive the windows of a [Machine]. */
internal class MemoryOpeningMarks : OpeningMarks {
    val times = mutableMapOf<String, Long>()

    override fun put(name: String, time: Long) {
        times[name] = time
    }

    override fun remove(name: String) {
        times.remove(name)
    }

    override fun timeOf(name: String): Long? = times[name]
}

/** A store that can be full, and counts how often each text is read. */
internal class FillingStore(private val disk: MemoryStore = MemoryStore()) : KeyValueStore by disk {
    var full = false
    val reads = mutableMapOf<String, Int>()

    override suspend fun read(name: String): String? {
        reads[name] = (reads[name] ?: 0) + 1
        return disk.read(name)
    }

    override var isAnswering = true

    override suspend fun write(name: String, text: String): StoreResult = when {
        !isAnswering -> StoreResult.NoAnswer
        full -> StoreResult.Full
        else -> disk.write(name, text)
    }
}

internal class RememberingClipboard : Sharing {
    var text: String? = null

    override suspend fun share(text: String): Boolean {
        this.text = text
        return true
    }
}

/** A machine with files, a store and a clipboard, on which tests open and close windows. */
internal class Machine {
    val files = MemoryFilePicker()
    val store = FillingStore()
    val clipboard = RememberingClipboard()
    val clock = FixedClock(now = 1_000_000)
    val marks = MemoryOpeningMarks()

    /** The app's own base URL of links. */
    var page = "https://school.example/robotran/"

    fun window(vararg openRequests: OpenRequest): Workshop = tab(NoWindowMemory, *openRequests)

    /** A browser tab with the memory [memory]. */
    fun tab(memory: WindowMemory, vararg openRequests: OpenRequest): Workshop {
        val waiting = OpenRequests().also { openRequests.forEach(it::bring) }
        return runBlocking {
            openWorkshop(platform = platform(memory, waiting))
        }
    }

    fun platform(memory: WindowMemory = NoWindowMemory, waiting: OpenRequests = OpenRequests()) = MemoryPlatform(
        NoLoudSpeaker,
        store,
        files,
        clipboard,
        clock,
        waiting,
        memory,
        page,
        openingMarks = marks,
        showsRecentFiles = true,
    )

    /** This machine after all its windows were killed, which releases their claims and leaves their marks. */
    fun afterKill(): Machine {
        val next = Machine()
        runBlocking { for (name in store.names()) next.store.write(name, store.read(name).orEmpty()) }
        next.marks.times += marks.times
        next.clock.now = clock.now
        next.files.disk += files.disk
        return next
    }
}

/**
 * The memory of one tab.
 *
 * @param texts the unsaved changes that all tabs of a browser share.
 */
internal class TabMemory(
    override var projectId: String? = null,
    private val texts: MutableMap<String, String> = mutableMapOf(),
) : WindowMemory {
    /** Whether the previous page ended normally. */
    var hasEnded = true

    override fun hasEnded(id: String): Boolean = hasEnded

    override fun leave(id: String, text: String?) {
        if (text == null) texts.remove(id) else texts[id] = text
    }

    override fun left(id: String): String? = texts[id]

    override fun leftIds(): List<String> = texts.keys.toList()
}

/** Writes [text] and simulates a pause in typing. */
internal fun Workshop.write(text: String) {
    handle(ProgramEvent.ProgramEdited(text))
    keep()
}

/** All projects in the list My work. */
internal fun Workshop.projects(): List<ProjectListEntry> {
    handle(DocumentEvent.ProjectListRequested)
    val projects = checkNotNull((state.document.dialog as DocumentDialog.ProjectList).projects)
    handle(DocumentEvent.DialogClosed)
    return projects
}

/** Simulates a pause, in which the project is autosaved. */
internal fun Workshop.keep() = runBlocking { saveDocumentNow() }

internal fun projectFile(text: String, name: String = "maze.robotran"): OpenedFile {
    val world = BuiltInWorlds.plain.copy(title = "Maze")
    val program = ProjectProgram(Program("maze.robo", ProgramLanguage.ROBOLANG, text))
    val project = Project(world, listOf(ProjectRobot(world.robots.first().name, listOf(program))))
    return OpenedFile(name, writeProject(project).encodeToByteArray(), "/home/$name")
}
