package robotran.workshop.export

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import robotran.documents.fileNameFor
import robotran.workshop.event.ExportEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Printing
import robotran.workshop.platform.Saving
import robotran.workshop.service.Services
import robotran.workshop.state.ExportState
import robotran.workshop.state.MadePicture
import robotran.workshop.state.MadeWork
import robotran.workshop.state.MovingKind
import robotran.workshop.state.Poster
import robotran.workshop.state.ShowError
import robotran.workshop.state.ShowStep

/**
 * Makes what pupils show of their work: moving pictures, pictures, posters. One piece of work runs at a time. The run
 * stands still meanwhile.
 *
 * @param title the project's name, for files and posters.
 */
class ExportStateHolder(services: Services, private val title: () -> String) {
    private val platform = services.platform
    private val scope = services.scope
    private val preferences = services.preferences
    private val current = services.current
    private val run = services.runControls

    /** Null while the sheet is closed. */
    var state: ExportState? by mutableStateOf(null)
        private set

    private val maker = MovingPictureMaker(platform)
    private var work: Job? = null

    /** What the pupil wrote on the last poster. It is saved nowhere. */
    private var makerName = ""
    private var isDated = false

    fun handle(event: ExportEvent) {
        if (event == ExportEvent.Requested) return begin()
        val step = state?.step ?: return
        when (event) {
            ExportEvent.Requested -> Unit
            is ExportEvent.MovingChosen -> chooseSpeed(event.kind)
            is ExportEvent.SpeedChosen -> if (step is ShowStep.ChoosingSpeed) show(step.copy(chosen = event.speed))
            ExportEvent.MakingRequested -> make(step)
            is ExportEvent.StillChosen -> work { makeStill(event.kind) }
            ExportEvent.PosterChosen -> show(ShowStep.ChoosingPoster(firstPoster(), isDated))
            is ExportEvent.PosterChanged -> if (step is ShowStep.ChoosingPoster) change(step, event)
            is ExportEvent.PosterKindChosen -> if (step is ShowStep.ChoosingPoster) show(step.copy(kind = event.kind))
            ExportEvent.SaveRequested -> if (step is ShowStep.Made) work { save(step) }
            ExportEvent.ShareRequested -> if (step is ShowStep.Made) work { share(step) }
            ExportEvent.PrintRequested -> if (step is ShowStep.Made) work { print(step) }
            ExportEvent.BackRequested -> goBack()
            ExportEvent.Closed -> close()
        }
    }

    /** Cancels whatever is under way and closes the sheet. */
    fun close() {
        cancel()
        state = null
    }

    private fun begin() {
        if (state != null) return
        state = ExportState(
            ShowStep.Choosing,
            canRecord = platform.videos.isAvailable,
            canPrint = platform.posters.canPrint,
            canShare = platform.sharing.canShareFiles,
            hasRun = run.recordedRun().length > 0,
        )
    }

    private fun goBack() {
        cancel()
        show(ShowStep.Choosing)
    }

    private fun chooseSpeed(kind: MovingKind) {
        val speeds = speedsFor(run.recordedRun().length)
        show(ShowStep.ChoosingSpeed(kind, speeds, proposedSpeed(speeds)))
    }

    private fun make(chosen: ShowStep) {
        when (chosen) {
            is ShowStep.ChoosingSpeed -> work { makeMoving(chosen) }
            is ShowStep.ChoosingPoster -> work { makePoster(chosen) }
            else -> Unit
        }
    }

    private suspend fun makeMoving(chosen: ShowStep.ChoosingSpeed) {
        show(ShowStep.Making(chosen.kind, progress = 0f))
        val recorded = run.recordedRun()
        maker.make(recorded, chosen.kind, chosen.chosen).collect { step ->
            when (step) {
                is MakingStep.Progress -> show(ShowStep.Making(chosen.kind, step.part))

                is MakingStep.Done -> made(
                    step.bytes,
                    chosen.kind.fileKind,
                    MadePicture.Moving(recorded.world, step.states, FRAME_MILLISECONDS),
                )

                MakingStep.TooLarge -> show(ShowStep.Failed(ShowError.TooLarge))
                MakingStep.NoVideo -> show(ShowStep.Failed(ShowError.NoVideo))
            }
        }
    }

    private suspend fun makeStill(kind: FileKind) {
        val world = run.recordedRun().world
        val session = current.session
        val bytes = when (kind) {
            FileKind.SVG -> platform.pictures.svg(world, session).encodeToByteArray()
            else -> platform.pictures.png(world, session)
        }
        made(bytes, kind, MadePicture.Still(world, session))
    }

    private suspend fun makePoster(chosen: ShowStep.ChoosingPoster) {
        val poster = chosen.poster
        val picture = if (chosen.kind == FileKind.PNG) platform.posters.png(poster) else null
        val bytes = picture ?: platform.posters.svg(poster).encodeToByteArray()
        val kind = if (picture == null) FileKind.SVG else FileKind.PNG
        made(bytes, kind, MadePicture.Page(poster), poster.title)
    }

    private fun made(bytes: ByteArray, kind: FileKind, shown: MadePicture, name: String = title()) =
        show(ShowStep.Made(MadeWork(fileNameFor(name, kind), kind, bytes, shown)))

    private fun firstPoster() = Poster(
        title().take(Poster.MAX_TITLE),
        makerName,
        dateOf(isDated),
        run.recordedRun().world,
        current.session,
        current.shownProgram,
        preferences.language,
        current.shownBlocks,
    )

    private fun change(step: ShowStep.ChoosingPoster, event: ExportEvent.PosterChanged) {
        makerName = event.maker.take(Poster.MAX_MAKER)
        isDated = event.isDated
        val title = event.title.take(Poster.MAX_TITLE)
        val poster = step.poster.copy(title = title, maker = makerName, date = dateOf(isDated))
        show(step.copy(poster = poster, isDated = isDated))
    }

    private fun dateOf(isDated: Boolean): String =
        if (isDated) platform.clock.date(platform.clock.now, preferences.language.tag) else ""

    private suspend fun print(made: ShowStep.Made) {
        val page = made.work.shown as? MadePicture.Page ?: return
        val printing = platform.posters.print(page.poster)
        show(made.copy(error = (printing as? Printing.Failed)?.let { ShowError.NotPrinted(it.reason) }))
    }

    private suspend fun share(made: ShowStep.Made) {
        val isTaken = platform.sharing.shareFile(made.work.name, made.work.kind, made.work.bytes)
        show(made.copy(error = if (isTaken) null else ShowError.NotShared))
    }

    private suspend fun save(made: ShowStep.Made) {
        when (val saving = platform.files.save(made.work.name, made.work.kind, made.work.bytes)) {
            is Saving.Saved -> show(made.copy(savedAs = saving.name, error = null))
            is Saving.Failed -> show(made.copy(error = ShowError.NotSaved(saving.reason, saving.isFull)))
            Saving.Cancelled -> show(made.copy(error = null))
        }
    }

    private fun work(block: suspend () -> Unit) {
        cancel()
        work = scope.launch { block() }
    }

    private fun cancel() {
        work?.cancel()
        work = null
    }

    private fun show(step: ShowStep) {
        state = state?.copy(step = step)
    }
}

private val MovingKind.fileKind: FileKind get() = when (this) {
    MovingKind.PICTURE -> FileKind.GIF
    MovingKind.VIDEO -> FileKind.WEBM
}
