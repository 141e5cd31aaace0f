package robotran.ui.screen

import androidx.compose.runtime.Composable
import robotran.editing.RobotTexts
import robotran.ui.assignment.worldName
import robotran.ui.learning.robotTitle
import robotran.ui.run.texts.RunTexts
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.LearningTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.ui.screen.texts.ScreenTexts
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.NxtTexts
import robotran.uikit.*
import robotran.workshop.state.Notice
import robotran.workshop.state.NoticeAction
import robotran.world.messages.sentence
import robotran.world.robot.DraftError

/** The localised text of [notice]. */
@Composable
fun noticeText(notice: Notice): String = when (notice) {
    is Notice.ExternalError -> notice.sentence
    is Notice.WithWarnings -> withWarnings(notice)
    Notice.Unexpected -> DocumentTexts.unexpected(spoken)
    is Notice.ProgramTooLong -> tooLong(notice)
    Notice.FixOutdated -> ScreenTexts.programFixGone(spoken)
    is Notice.NamesInTheWay -> ScreenTexts.programNamesInTheWay(spoken, notice.language.ownName, notice.names)
    Notice.NoSlotForTask -> LearningTexts.worldNoRoom(spoken)
    Notice.NoSlotForExample -> LearningTexts.helpNoRoom(spoken)
    is Notice.NoSlotForProgram -> DocumentTexts.noRoom(spoken, notice.program, notice.maxPrograms)
    Notice.LogCopied -> RunTexts.logCopied(spoken)
    Notice.LogNotCopied -> RunTexts.logNotCopied(spoken)
    Notice.LinkNotCopied -> DocumentTexts.notCopied(spoken)
    is Notice.FileSaved -> DocumentTexts.saved(spoken, notice.name)
    is Notice.FileNotSaved -> notSaved(notice)
    Notice.StoreSilent -> CommonTexts.troubleSilent(spoken)
    Notice.ProjectTooLong -> DocumentTexts.tooLong(spoken)
    is Notice.FileOpenElsewhere -> DocumentTexts.openElsewhere(spoken, notice.name)
    is Notice.MoreProjectsOpened -> DocumentTexts.openedMore(spoken, notice.others)
    is Notice.TooManyCourses -> SchoolTexts.courseTooMany(spoken, notice.max)
    Notice.CourseTooLong -> SchoolTexts.courseTooLong(spoken)
    Notice.ReplayEmpty -> DocumentTexts.replayEmpty(spoken)
    is Notice.KitNeedsCorrectProgram -> DocumentTexts.kitMistake(spoken, notice.line)
    Notice.CompilerMissing -> RunTexts.statusNoCompiler(spoken)
    is Notice.ProjectOpenElsewhere -> openElsewhere(notice)
    is Notice.LastProjectOpenElsewhere -> openElsewhere(notice)
    Notice.OwnProjectOpenElsewhere -> DocumentTexts.ownElsewhere(spoken)
    is Notice.ProjectUnusable -> DocumentTexts.workUnusable(spoken, notice.reason)
    is Notice.ProjectNotDeleted -> DocumentTexts.deleteFailed(spoken, notice.reason)
    is Notice.ProjectRestored -> restored(notice)
    is Notice.OtherProjectsOpen -> othersOpen(notice)(spoken)
    is Notice.EarlierProjectSaved -> DocumentTexts.keptBefore(spoken)
    is Notice.AssignmentBegunBefore -> SchoolTexts.assignmentBegunBefore(spoken)
    Notice.BegunAgain -> SchoolTexts.assignmentBegunAgain(spoken)
    Notice.WorldOfAssignment -> SchoolTexts.assignmentWorldLocked(spoken)
    is Notice.WorldSolved -> LearningTexts.worldDone(spoken, notice.title)
    is Notice.SensorsPluggedIn -> pluggedIn(notice)
    is Notice.RobotReplaced -> RobotTexts.replaced(spoken, notice.robot, robotTitle(notice.description))
    Notice.FirstProgramRuns -> ScreenTexts.noticeTryChange(spoken)
    is Notice.HandInOpened -> opened(notice)
    Notice.HandInOpen -> ""
    is Notice.RobotImpossible -> RobotTexts.impossible(spoken, notice.draft.draft.title, faultOf(notice.draft))
    is Notice.RobotKeptAsDraft -> RobotTexts.keptAsDraft(spoken, notice.draft.draft.title, faultOf(notice.draft))
    Notice.EscapeAlone -> NxtTexts.escapeAlone(spoken)
    Notice.NewBranch -> RunTexts.newFuture(spoken)
    is Notice.RunHeard -> heardText(notice)
}

@Composable
private fun heardText(notice: Notice.RunHeard): String = when {
    notice.isMuted -> RunTexts.hearsButMuted(spoken)
    notice.on -> RunTexts.hears(spoken)
    else -> RunTexts.hearsNot(spoken)
}

/** The label of [action]. */
internal fun noticeActionText(action: NoticeAction): Label = when (action) {
    NoticeAction.ShowProjects -> CommonTexts::myWork
    is NoticeAction.GoBack -> DocumentTexts::goBack
    is NoticeAction.GoOn -> SchoolTexts::assignmentGoOn
    NoticeAction.ChangeNumber -> ScreenTexts::noticeChangeNumber
    NoticeAction.BackToHandIns -> SchoolTexts::handInGoBack
    NoticeAction.BeginningUndone -> DocumentTexts::undo
    NoticeAction.UnplugSensors -> DocumentTexts::undo
    NoticeAction.BringRobotBack -> DocumentTexts::undo
    is NoticeAction.BuildOn -> RobotTexts::toBench
}

@Composable
private fun tooLong(notice: Notice.ProgramTooLong): String =
    ScreenTexts.programTooLong(spoken, notice.maxThousandCharacters, notice.maxThousandLines)

@Composable
private fun openElsewhere(notice: Notice.ProjectOpenElsewhere): String =
    DocumentTexts.workElsewhere(spoken, notice.name.ifEmpty { DocumentTexts.untitled(spoken) })

@Composable
private fun openElsewhere(notice: Notice.LastProjectOpenElsewhere): String = if (notice.name.isEmpty()) {
    DocumentTexts.ownElsewhere(spoken)
} else {
    DocumentTexts.lastElsewhere(spoken, notice.name)
}

@Composable
private fun pluggedIn(notice: Notice.SensorsPluggedIn): String =
    notice.ports.singleOrNull()?.let { RunTexts.pluggedIn(spoken, it) }
        ?: RunTexts.pluggedInSeveral(spoken, notice.ports)

@Composable
private fun opened(notice: Notice.HandInOpened): String = notice.run?.let { run ->
    val world = worldName(run.world)
    SchoolTexts.handInNoticeRun(spoken, notice.name, world, run.seed)
} ?: SchoolTexts.handInNotice(spoken, notice.name)

@Composable
private fun faultOf(robot: DraftError): String = robot.error.sentence(LocalLanguage.current)

@Composable
private fun notSaved(notice: Notice.FileNotSaved): String =
    if (notice.isFull) DocumentTexts.saveFull(spoken) else DocumentTexts.saveFailed(spoken, notice.reason)

@Composable
private fun restored(notice: Notice.ProjectRestored): String = if (notice.name.isEmpty()) {
    DocumentTexts.backUnnamed(spoken)
} else {
    DocumentTexts.back(spoken, notice.name)
}

private fun othersOpen(notice: Notice.OtherProjectsOpen): Label =
    if (notice.isRestored) DocumentTexts::backOthers else DocumentTexts::othersThere

/** What people have to know first, then what can be mended later. */
@Composable
private fun withWarnings(notice: Notice.WithWarnings): String {
    val first = notice.notice?.let { noticeText(it) }
    val more = notice.warnings.size - SHOWN_WARNINGS
    val rest = if (more > 0) DocumentTexts.moreRemarks(spoken, more) else null
    return (listOfNotNull(first) + notice.warnings.take(SHOWN_WARNINGS) + listOfNotNull(rest)).filter {
        it.isNotEmpty()
    }
        .joinToString("\n")
}

/** As many as fit on a phone. */
private const val SHOWN_WARNINGS = 3
