package robotran.workshop.documents

import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.withContext
import robotran.documents.ZipEntry
import robotran.documents.fileNameFor
import robotran.documents.projectFile
import robotran.documents.zipOf
import robotran.programs.ProgramReader
import robotran.programs.ProgramResult
import robotran.projects.LinkMaking
import robotran.projects.linkOf
import robotran.robolang.RobolangResult
import robotran.robolang.readRobolang
import robotran.robolang.translate.KitFile
import robotran.robolang.translate.javaKitFiles
import robotran.robolang.translate.kitFiles
import robotran.robolang.translate.translateRobolang
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Saving
import robotran.workshop.programs.fileNameFor
import robotran.workshop.service.Bench
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.PENBOT_CALIBRATION
import robotran.workshop.state.ProgramLanguage
import robotran.workshop.state.PupilProgram

/** Gives the work away: as a link, as a picture, as a replay, as programs for elsewhere. */
internal class DocumentExports(
    private val bench: Bench,
    private val keeper: DocumentKeeper,
    private val show: (DocumentDialog?) -> Unit,
) {
    /** A link without the address of a page leads nowhere, so where there is none, it is the file that is shared. */
    suspend fun makeLink() {
        val address = bench.platform.pageAddress.ifEmpty { bench.settings.site }
        if (address.isEmpty()) return show(DocumentDialog.SharingFile)
        show(DocumentDialog.SharingLink())
        val making = withContext(bench.platform.background) { linkOf(bench.project, bench.language) }
        show(
            when (making) {
                is LinkMaking.Made -> DocumentDialog.SharingLink(link = address + making.fragment)
                is LinkMaking.TooLong -> DocumentDialog.SharingLink(tooLong = making.message)
            },
        )
    }

    suspend fun copyLink(dialog: DocumentDialog?) {
        val sharing = dialog as? DocumentDialog.SharingLink ?: return
        val copied = bench.platform.sharing.copy(sharing.link ?: return)
        show(sharing.copy(copied = copied))
        if (!copied) bench.say(Notice.LinkNotCopied)
    }

    suspend fun shareLink(dialog: DocumentDialog?) {
        val sharing = dialog as? DocumentDialog.SharingLink ?: return
        bench.platform.sharing.share(sharing.link ?: return)
    }

    /** The sheet as it is now, as a picture of [kind]. */
    suspend fun savePicture(kind: FileKind) {
        val world = bench.project.world
        val state = bench.session
        val bytes = when (kind) {
            FileKind.SVG -> bench.platform.pictures.svg(world, state).encodeToByteArray()
            else -> bench.platform.pictures.png(world, state)
        }
        save(title(), kind, bytes)
    }

    suspend fun saveReplay() {
        val replay = bench.replay
        if (replay.inputs.isEmpty()) return bench.say(Notice.ReplayEmpty)
        val bytes = withContext(bench.platform.background) { projectFile(replay) }
            ?: return bench.say(Notice.ProjectTooLong)
        save("${title()} replay", FileKind.PROJECT, bytes)
    }

    suspend fun saveProgram() {
        val program = bench.shownProgram
        val kind = if (program.language == ProgramLanguage.JAVA) FileKind.JAVA else FileKind.ROBOLANG
        val single = program.files.singleOrNull()
        if (single != null) {
            save(program.name, kind, single.text.encodeToByteArray())
        } else {
            save(program.name, FileKind.ZIP, zipOf(program.files.map { ZipEntry(it.name, it.text.encodeToByteArray()) }))
        }
    }

    suspend fun saveKit() {
        val program = bench.shownProgram
        if (program.language == ProgramLanguage.JAVA) return saveJavaKit(program)
        val text = program.files.single().text
        when (val result = readRobolang(program.name, text, PENBOT_CALIBRATION)) {
            is RobolangResult.Mistaken -> {
                bench.say(Notice.KitNeedsCorrectProgram(result.diagnostics.first().range.line))
            }

            is RobolangResult.Ready -> {
                saveKit(program, kitFiles(translateRobolang(result.program), program.name, text))
            }
        }
    }

    private suspend fun saveJavaKit(program: PupilProgram) {
        val source = program.source()
        val reader = ProgramReader(PENBOT_CALIBRATION, language = bench.language)
        val result = try {
            withContext(bench.platform.background) { reader.read(source) }
        } catch (cancelled: CancellationException) {
            throw cancelled
        } catch (_: Throwable) {
            return bench.say(Notice.CompilerMissing)
        }
        when (result) {
            is ProgramResult.Mistaken -> {
                bench.say(Notice.KitNeedsCorrectProgram(result.mistakes.first().range?.line ?: 1))
            }

            is ProgramResult.Ready -> {
                saveKit(program, javaKitFiles(checkNotNull(result.mainClass), program.files.map { KitFile(it.name, it.text) }))
            }
        }
    }

    private suspend fun saveKit(program: PupilProgram, files: List<KitFile>) =
        save(program.name, FileKind.ZIP, zipOf(files.map { ZipEntry(it.path, it.text.encodeToByteArray(), it.isExecutable) }))

    private suspend fun save(name: String, kind: FileKind, bytes: ByteArray) {
        when (val saving = bench.platform.files.save(fileNameFor(name, kind), kind, bytes)) {
            is Saving.Saved -> bench.say(Notice.FileSaved(saving.name))
            is Saving.Failed -> bench.sayNotSaved(saving)
            Saving.GivenUp -> Unit
        }
    }

    private fun title() = keeper.name.ifEmpty { bench.project.world.title }
}
