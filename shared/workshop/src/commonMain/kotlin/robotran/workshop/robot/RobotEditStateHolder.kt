package robotran.workshop.robot

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import robotran.documents.FileKind
import robotran.documents.fileNameFor
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotEditing
import robotran.robotediting.after
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.state.Notice
import robotran.workshop.state.RobotEditState
import robotran.workshop.state.WorldEditState
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.file.RobotFileResult
import robotran.world.file.readRobot
import robotran.world.file.writeRobot
import robotran.world.robot.draftError
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit

/**
 * Holds the robot in the workbench. Each of its states goes into the edited world at once, an impossible one as a
 * draft; all of them are one undo step of the world editor.
 *
 * @param worldEdit the world editor; null while it is closed.
 * @param editWorld changes it.
 */
internal class RobotEditStateHolder(
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val preferences: Preferences,
    private val notices: Notices,
    private val worldEdit: () -> WorldEditState?,
    private val editWorld: (WorldEditEvent) -> Unit,
) {
    /** With its undo history, for the same robot. */
    private var latest: RobotEditing? = null

    /** Whether the workbench has opened the world editor, too. */
    private var closesWorld = false

    var state: RobotEditState? by mutableStateOf(null)
        private set

    fun handle(event: RobotEditEvent) {
        when (event) {
            is RobotEditEvent.BenchOpened -> open(event.robot)
            is RobotEditEvent.Edited -> edit(event.edit)
            RobotEditEvent.BenchClosed -> close()
            is RobotEditEvent.SheetShown -> showSheet(event.shown)
            RobotEditEvent.OpenRequested -> scope.launch { openFile() }
            RobotEditEvent.SaveRequested -> save()

            RobotEditEvent.HintsClosed -> {
                state =
                    state?.copy(hintsShown = false, fileError = null, isSavingRefused = false)
            }
        }
    }

    /** Called when another world is loaded; the states of the robot are in the old one. */
    fun leave() {
        latest = null
        state = null
    }

    private fun open(robot: Int) {
        if (state != null) return
        closesWorld = worldEdit() == null
        if (closesWorld) editWorld(WorldEditEvent.EditorOpened)
        val place = placeOf(robot) ?: return
        editWorld(WorldEditEvent.Edited(WorldEdit.Select(ElementRef(ElementKind.ROBOT, robot))))
        editWorld(WorldEditEvent.Edited(WorldEdit.FinishChange))
        val description = place.draft ?: place.description
        val editing = latest?.takeIf { it.robot == description } ?: RobotEditing.of(description)
        state = RobotEditState(
            editing.after(RobotEdit.Choose(null)).after(RobotEdit.FinishChange),
            robot,
            place.colour,
        )
    }

    private fun placeOf(robot: Int): RobotPlacement? = worldEdit()?.world?.robots?.getOrNull(robot)

    private fun edit(edit: RobotEdit) {
        val now = state ?: return
        val editing = now.editing.after(edit)
        val hasNews = edit is RobotEdit.Add || editing.error != null || editing.errors != now.editing.errors
        state = now.copy(
            editing = editing,
            fileError = null,
            isSavingRefused = now.isSavingRefused && !editing.isPossible,
            hintsShown = now.hintsShown || hasNews,
            number = if (isAnother(edit, now.editing, editing)) now.number + 1 else now.number,
        )
        if (editing.gesture == null) keep(now.robot, editing)
    }

    private fun isAnother(edit: RobotEdit, before: RobotEditing, after: RobotEditing): Boolean = when (edit) {
        is RobotEdit.Replace -> true

        RobotEdit.Undo, RobotEdit.Redo -> {
            before.robot.title != after.robot.title &&
                before.robot.base != after.robot.base
        }

        else -> false
    }

    private fun keep(robot: Int, editing: RobotEditing) {
        val place = placeOf(robot) ?: return
        val changed = place.with(editing.robot, editing.isPossible)
        if (changed == place) return
        val element = Element.OfRobot(changed)
        editWorld(WorldEditEvent.Edited(WorldEdit.Change(ElementRef(ElementKind.ROBOT, robot), element)))
    }

    /** An impossible robot does not replace the one that drives. */
    private fun RobotPlacement.with(robot: RobotDescription, isPossible: Boolean): RobotPlacement =
        if (isPossible) copy(description = robot, draft = null) else copy(draft = robot)

    private fun close() {
        val now = state ?: return
        edit(RobotEdit.Drop)
        latest = state?.editing ?: now.editing
        state = null
        editWorld(WorldEditEvent.Edited(WorldEdit.FinishChange))
        val draft = worldEdit()?.world?.let { draftError(it, now.robot) }
        if (closesWorld) editWorld(WorldEditEvent.EditorClosed)
        draft?.let { notices.show(Notice.RobotKeptAsDraft(it)) }
    }

    private fun showSheet(shown: Boolean) {
        edit(RobotEdit.Drop)
        state = state?.copy(sheetShown = shown)
    }

    private suspend fun openFile() {
        val file = platform.files.open(listOf(FileKind.ROBOT)).firstOrNull() ?: return
        when (val result = readRobot(file.bytes, preferences.language)) {
            is RobotFileResult.Success -> {
                edit(RobotEdit.Replace(result.robot))
                notices.add(result.warnings.map { "${file.name}: ${it.message}" })
            }

            is RobotFileResult.Failure -> state = state?.copy(fileError = result.message, hintsShown = true)
        }
    }

    /** A robot that was a ready one gets another title, so that their files and notices differ. */
    private fun giveOwnTitle() {
        val robot = state?.editing?.robot ?: return
        val ready = ReadyRobots.all.values.find { it.title == robot.title }
        if (ready == null || ready == robot) return
        edit(RobotEdit.Change(robot.copy(title = "${robot.title} 2")))
    }

    private fun save() {
        val now = state ?: return
        edit(RobotEdit.Drop)
        if (!(state ?: now).editing.isPossible) {
            state = state?.copy(isSavingRefused = true, hintsShown = true)
            return
        }
        giveOwnTitle()
        val robot = (state ?: now).editing
        scope.launch {
            val name = fileNameFor(robot.robot.title, FileKind.ROBOT)
            when (
                val saving = platform.files.save(name, FileKind.ROBOT, writeRobot(robot.robot).encodeToByteArray())
            ) {
                is Saving.Saved -> notices.show(Notice.FileSaved(saving.name))
                Saving.Cancelled -> Unit
                is Saving.Failed -> notices.show(Notice.FileNotSaved(saving.reason, saving.isFull))
            }
        }
    }
}
