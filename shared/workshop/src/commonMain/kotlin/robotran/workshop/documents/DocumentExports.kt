package robotran.workshop.documents

import kotlinx.coroutines.withContext
import robotran.assignments.doing.pupilCopy
import robotran.documents.ZipEntry
import robotran.documents.fileKind
import robotran.documents.fileNameFor
import robotran.documents.projectFile
import robotran.documents.zipOf
import robotran.language.ProgramLanguage
import robotran.legofirmware.image.toBytes
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.TimedCompilation
import robotran.programs.brickOf
import robotran.programs.firmwareImage
import robotran.projects.LinkCreation
import robotran.projects.linkOf
import robotran.projects.penbotTarget
import robotran.projects.target
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.robot.RobotTarget
import robotran.robolang.translate.KitFile
import robotran.robolang.translate.javaKitFiles
import robotran.robolang.translate.kitFiles
import robotran.robolang.translate.translateRobolang
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.PupilProgram

/** Exports the project: as a link, a replay, or programs for other tools. */
internal class DocumentExports(
    private val platform: Platform,
    private val preferences: Preferences,
    private val current: CurrentProject,
    private val notices: Notices,
    private val autosaver: DocumentAutosaver,
    private val view: DocumentView,
) {
    /** A link needs the page's URL. Without one the file is shared instead. */
    suspend fun makeLink() {
        val address = platform.pageAddress.ifEmpty { preferences.settings.site }
        if (address.isEmpty()) return view.show(DocumentDialog.SharingFile)
        view.show(DocumentDialog.SharingLink())
        val making = withContext(platform.background) { linkOf(shared(), preferences.language) }
        view.show(
            when (making) {
                is LinkCreation.Made -> DocumentDialog.SharingLink(link = address + making.fragment)
                is LinkCreation.TooLong -> DocumentDialog.SharingLink(tooLong = making.message)
            },
        )
    }

    /** What an assignment's author gives away has neither checks nor solution. */
    private fun shared() = current.project.let { if (it.assignment?.checks == null) it else pupilCopy(it) }

    suspend fun copyLink() {
        val sharing = view.dialog as? DocumentDialog.SharingLink ?: return
        val copied = platform.sharing.copy(sharing.link ?: return)
        view.show(sharing.copy(copied = copied))
        if (!copied) notices.show(Notice.LinkNotCopied)
    }

    suspend fun shareLink() {
        val sharing = view.dialog as? DocumentDialog.SharingLink ?: return
        platform.sharing.share(sharing.link ?: return)
    }

    suspend fun saveReplay() {
        val replay = current.replay
        if (replay.inputs.isEmpty()) return notices.show(Notice.ReplayEmpty)
        val bytes = withContext(platform.background) { projectFile(replay) }
            ?: return notices.show(Notice.ProjectTooLong)
        save("${title()} replay", FileKind.PROJECT, bytes)
    }

    suspend fun saveProgram() {
        val program = current.shownProgram
        val kind = program.language.fileKind
        val single = program.files.singleOrNull()
        if (single != null) {
            save(program.name, kind, single.text.encodeToByteArray())
        } else {
            save(
                program.name,
                FileKind.ZIP,
                zipOf(
                    program.files.map {
                        ZipEntry(it.name, it.text.encodeToByteArray())
                    },
                ),
            )
        }
    }

    suspend fun saveKit() {
        val program = current.shownProgram
        when (program.language) {
            ProgramLanguage.ROBOLANG -> saveRobolangKit(program)
            ProgramLanguage.JAVA -> saveJavaKit(program)
            ProgramLanguage.NQC, ProgramLanguage.LASM -> saveFirmwareImage(program)
        }
    }

    private suspend fun saveRobolangKit(program: PupilProgram) {
        val text = program.files.single().text
        when (val result = compileRobolang(program.name, text, targetOf(program))) {
            is RobolangResult.HasErrors -> {
                notices.show(Notice.KitNeedsCorrectProgram(result.diagnostics.first().range?.line ?: 1))
            }

            is RobolangResult.Ready -> saveKit(program, kitFiles(translateRobolang(result.program), program.name, text))
        }
    }

    /** The shown robot, or the penbot with the brick that [program] names. */
    private fun targetOf(program: PupilProgram): RobotTarget {
        val robot = current.shownRobot.description
        val brick = brickOf(program.source()) ?: robot.brick
        return if (brick == robot.brick) robot.target else brick.penbotTarget
    }

    private suspend fun saveJavaKit(program: PupilProgram) {
        val source = program.source()
        val target = targetOf(program)
        val reader = ProgramCompiler(target, language = preferences.language)
        val compiled = withContext(platform.background) { reader.compile(source) }
        val result = (compiled as? TimedCompilation.Compiled)?.result ?: return notices.show(Notice.CompilerMissing)
        when (result) {
            is ProgramResult.HasErrors -> {
                notices.show(Notice.KitNeedsCorrectProgram(result.diagnostics.first().range?.line ?: 1))
            }

            is ProgramResult.Ready -> {
                saveKit(
                    program,
                    javaKitFiles(
                        checkNotNull(result.mainClass),
                        program.files.map {
                            KitFile(it.name, it.text)
                        },
                        target.kind,
                    ),
                )
            }
        }
    }

    /** What a real brick with LEGO's firmware runs. */
    private suspend fun saveFirmwareImage(program: PupilProgram) {
        val compiler = ProgramCompiler(targetOf(program), language = preferences.language)
        when (val result = withContext(platform.background) { compiler.compileNow(program.source()) }) {
            is ProgramResult.HasErrors -> {
                notices.show(Notice.KitNeedsCorrectProgram(result.diagnostics.first().range?.line ?: 1))
            }

            is ProgramResult.Ready -> {
                val image = checkNotNull(result.firmwareImage) { "${program.name} is not for LEGO's firmware." }
                val name = program.name.removeSuffix(program.language.extension)
                save(name, FileKind.RCX_IMAGE, image.toBytes())
            }
        }
    }

    private suspend fun saveKit(program: PupilProgram, files: List<KitFile>) = save(
        program.name,
        FileKind.ZIP,
        zipOf(
            files.map {
                ZipEntry(it.path, it.text.encodeToByteArray(), it.isExecutable)
            },
        ),
    )

    private suspend fun save(name: String, kind: FileKind, bytes: ByteArray) {
        when (val saving = platform.files.save(fileNameFor(name, kind), kind, bytes)) {
            is Saving.Saved -> notices.show(Notice.FileSaved(saving.name))
            is Saving.Failed -> notices.show(Notice.FileNotSaved(saving.reason, saving.isFull))
            Saving.Cancelled -> Unit
        }
    }

    private fun title() = autosaver.name.ifEmpty { current.project.world.title }
}
