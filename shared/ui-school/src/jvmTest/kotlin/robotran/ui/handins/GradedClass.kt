package robotran.ui.handins

import kotlinx.coroutines.runBlocking
import robotran.projects.Project
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.handins.AnyClass
import robotran.workshop.openWorkshop
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.FilePicker
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.NoFilePicker
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.Settings

/** What the screens show does not depend on how many seeds there are. */
private val quickToGrade = AnyClass.teachers.run {
    copy(assignment = assignment?.run { copy(checks = checks?.copy(seeds = 1..3)) })
}

/** A workshop with the page on which [files] are graded for [assignment]. */
internal fun gradedClass(
    files: List<OpenedFile>,
    settings: Settings = Settings(lessMotion = true),
    assignment: Project = quickToGrade,
): Workshop {
    val workshop = runBlocking { openWorkshop(platform = MemoryPlatform(files = Brought(files))) }
    workshop.handle(SettingsEvent.SettingsChanged(settings))
    workshop.handle(DocumentEvent.FilesBrought(listOf(AnyAssignment.file(assignment, "Circle.robotran"))))
    workshop.awaiting { document.hasGoals }
    workshop.handle(HandInsEvent.Requested)
    workshop.awaiting { handIns?.isReading == false }
    if (files.isEmpty()) return workshop
    workshop.handle(HandInsEvent.FilesRequested)
    workshop.awaiting {
        handIns.let {
            it != null && it.rows.isNotEmpty() && it.rows.all { row -> row.graded != null } &&
                it.progress == null
        }
    }
    return workshop
}

/** Waits for work that goes on in slices. */
internal fun Workshop.awaiting(isDone: robotran.workshop.state.WorkshopState.() -> Boolean) {
    val end = System.nanoTime() + PATIENCE
    while (!state.isDone()) {
        check(System.nanoTime() < end) { "Nothing happened: ${state.handIns}" }
        Thread.sleep(10)
    }
}

private class Brought(private val files: List<OpenedFile>) : FilePicker by NoFilePicker {
    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> = files
}

private const val PATIENCE = 60_000_000_000L
