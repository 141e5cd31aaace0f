package robotran.ui.screen

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.assignment.worldName
import robotran.ui.language.LocalLanguage
import robotran.ui.learning.robotTitle
import robotran.ui.program.portNumbers
import robotran.ui.resources.*
import robotran.workshop.state.Notice
import robotran.workshop.state.NoticeAction
import robotran.world.messages.sentence

/** The localised text of [notice]. */
@Composable
internal fun noticeText(notice: Notice): String = when (notice) {
    is Notice.ForeignError -> notice.sentence
    is Notice.WithRemarks -> withRemarks(notice)
    Notice.Unexpected -> stringResource(Res.string.documents_unexpected)

    is Notice.ProgramTooLong -> stringResource(
        Res.string.program_too_long,
        notice.maxThousandCharacters,
        notice.maxThousandLines,
    )

    Notice.FixOutdated -> stringResource(Res.string.program_fix_gone)
    Notice.NoSlotForTask -> stringResource(Res.string.learning_world_no_room)
    Notice.NoSlotForExample -> stringResource(Res.string.learning_help_no_room)
    is Notice.NoSlotForProgram -> stringResource(Res.string.documents_no_room, notice.program, notice.maxPrograms)
    Notice.LogCopied -> stringResource(Res.string.run_log_copied)
    Notice.LogNotCopied -> stringResource(Res.string.run_log_not_copied)
    Notice.LinkNotCopied -> stringResource(Res.string.documents_not_copied)
    is Notice.FileSaved -> stringResource(Res.string.documents_saved, notice.name)
    is Notice.FileNotSaved -> stringResource(notSaved(notice), notice.reason)
    Notice.StoreSilent -> stringResource(Res.string.documents_trouble_silent)
    Notice.ProjectTooLong -> stringResource(Res.string.documents_too_long)
    is Notice.FileOpenElsewhere -> stringResource(Res.string.documents_open_elsewhere, notice.name)
    is Notice.MoreProjectsOpened -> stringResource(Res.string.documents_opened_more, notice.others)
    is Notice.TooManyCourses -> stringResource(Res.string.course_too_many, notice.max)
    Notice.CourseTooLong -> stringResource(Res.string.course_too_long)
    Notice.ReplayEmpty -> stringResource(Res.string.documents_replay_empty)
    is Notice.KitNeedsCorrectProgram -> stringResource(Res.string.documents_kit_mistake, notice.line)
    Notice.CompilerMissing -> stringResource(Res.string.status_no_compiler)

    is Notice.ProjectOpenElsewhere -> stringResource(
        Res.string.documents_work_elsewhere,
        notice.name.ifEmpty { stringResource(Res.string.documents_untitled) },
    )

    is Notice.LastProjectOpenElsewhere -> if (notice.name.isEmpty()) {
        stringResource(Res.string.documents_own_elsewhere)
    } else {
        stringResource(Res.string.documents_last_elsewhere, notice.name)
    }

    Notice.OwnProjectOpenElsewhere -> stringResource(Res.string.documents_own_elsewhere)
    is Notice.ProjectUnusable -> stringResource(Res.string.documents_work_unusable, notice.reason)
    is Notice.ProjectNotDeleted -> stringResource(Res.string.documents_delete_failed, notice.reason)
    is Notice.ProjectRestored -> restored(notice)
    is Notice.OtherProjectsOpen -> stringResource(othersOpen(notice))
    is Notice.EarlierProjectSaved -> stringResource(Res.string.documents_kept_before)
    is Notice.AssignmentBegunBefore -> stringResource(Res.string.assignment_begun_before)
    Notice.BegunAgain -> stringResource(Res.string.assignment_begun_again)
    Notice.WorldOfAssignment -> stringResource(Res.string.assignment_world_locked)
    is Notice.WorldSolved -> stringResource(Res.string.learning_world_done, notice.title)

    is Notice.SensorsPluggedIn -> notice.ports.singleOrNull()?.let { stringResource(Res.string.run_plugged_in, it) }
        ?: stringResource(Res.string.run_plugged_in_several, portNumbers(notice.ports))

    is Notice.RobotReplaced -> stringResource(Res.string.robot_replaced, notice.robot, robotTitle(notice.description))
    Notice.FirstProgramRuns -> stringResource(Res.string.notice_try_change)

    is Notice.HandInOpened -> notice.run?.let { run ->
        val world = worldName(run.world)
        stringResource(Res.string.hand_in_notice_run, notice.name, world, run.seed)
    } ?: stringResource(Res.string.hand_in_notice, notice.name)

    Notice.HandInOpen -> ""

    is Notice.RobotImpossible -> stringResource(
        Res.string.robot_impossible,
        notice.draft.draft.title,
        notice.draft.error.sentence(LocalLanguage.current),
    )

    is Notice.RobotKeptAsDraft -> stringResource(
        Res.string.robot_kept_as_draft,
        notice.draft.draft.title,
        notice.draft.error.sentence(LocalLanguage.current),
    )

    Notice.EscapeAlone -> stringResource(Res.string.nxt_escape_alone)
    Notice.NewBranch -> stringResource(Res.string.run_new_future)
}

/** The label of [action]. */
internal fun noticeActionText(action: NoticeAction): StringResource = when (action) {
    NoticeAction.ShowProjects -> Res.string.documents_my_work
    is NoticeAction.GoBack -> Res.string.documents_go_back
    is NoticeAction.GoOn -> Res.string.assignment_go_on
    NoticeAction.ChangeNumber -> Res.string.notice_change_number
    NoticeAction.BackToHandIns -> Res.string.hand_in_go_back
    NoticeAction.BeginningUndone -> Res.string.documents_undo
    NoticeAction.UnplugSensors -> Res.string.documents_undo
    NoticeAction.BringRobotBack -> Res.string.documents_undo
    is NoticeAction.BuildOn -> Res.string.robot_to_bench
}

private fun notSaved(notice: Notice.FileNotSaved): StringResource =
    if (notice.isFull) Res.string.documents_save_full else Res.string.documents_save_failed

@Composable
private fun restored(notice: Notice.ProjectRestored): String = if (notice.name.isEmpty()) {
    stringResource(Res.string.documents_back_unnamed)
} else {
    stringResource(Res.string.documents_back, notice.name)
}

private fun othersOpen(notice: Notice.OtherProjectsOpen): StringResource =
    if (notice.isRestored) Res.string.documents_back_others else Res.string.documents_others_there

/** What people have to know first, then what can be mended later. */
@Composable
private fun withRemarks(notice: Notice.WithRemarks): String {
    val first = notice.notice?.let { noticeText(it) }
    val more = notice.remarks.size - SHOWN_REMARKS
    val rest = if (more > 0) stringResource(Res.string.documents_more_remarks, more) else null
    return (listOfNotNull(first) + notice.remarks.take(SHOWN_REMARKS) + listOfNotNull(rest)).filter { it.isNotEmpty() }
        .joinToString("\n")
}

/** As many as fit on a phone. */
private const val SHOWN_REMARKS = 3
