package robotran.workshop.documents

import kotlinx.coroutines.withContext
import robotran.assignments.doing.pupilCopy
import robotran.documents.ZipEntry
import robotran.documents.fileKind
import robotran.documents.fileNameFor
import robotran.documents.projectFile
import robotran.documents.zipOf
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.toBytes
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.ProgramTranslation
import robotran.programs.TimedCompilation
import robotran.programs.brickOf
import robotran.programs.firmwareImage
import robotran.programs.support
import robotran.projects.LinkCreation
import robotran.projects.linkOf
import robotran.projects.penbotTarget
import robotran.projects.target
import robotran.robolang.RobolangProgram
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.python.PythonTranslation
import robotran.robolang.python.pythonOf
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

    suspend fun saveTranslation(translation: ProgramTranslation) =
        save(translation.fileName, translation.language.fileKind, translation.text.encodeToByteArray())

    /** Saves what a real brick needs to run the shown program: an image for LEGO's firmware, Python for a hub, or a kit for leJOS. */
    suspend fun saveKit() {
        val program = current.shownProgram
        val target = targetOf(program)
        val compiler = ProgramCompiler(target, language = preferences.language)
        val compiled = withContext(platform.background) { compiler.compile(program) }
        val result = (compiled as? TimedCompilation.Compiled)?.result ?: return notices.show(Notice.CompilerMissing)
        when (result) {
            is ProgramResult.Failure -> {
                notices.show(Notice.KitNeedsCorrectProgram(result.diagnostics.first().range?.line ?: 1))
            }

            is ProgramResult.Success -> {
                val image = result.firmwareImage
                val python = (result.program as? RobolangProgram)
                    ?.let { pythonOf(it, PythonTranslationMessages.of(preferences.language)) }
                when {
                    image != null -> saveImage(program, image)
                    python != null -> savePython(program, python)
                    else -> saveKit(program, kitOf(program, result, target))
                }
            }
        }
    }

    private fun kitOf(program: Program, compiled: ProgramResult.Success, target: RobotTarget): List<KitFile> =
        when (val runnable = compiled.program) {
            is RobolangProgram -> kitFiles(translateRobolang(runnable), program.name, program.text)

            else -> javaKitFiles(
                checkNotNull(compiled.mainClass),
                program.files.map { KitFile(it.name, it.text) },
                target.kind,
            )
        }

    /** The shown robot, or the penbot with the brick that [program] names. */
    private fun targetOf(program: Program): RobotTarget {
        val robot = current.shownRobot.description
        val brick = brickOf(program) ?: robot.brick
        val isItsOwn = program.language.support.files.isFor(brick, robot.brick)
        return if (isItsOwn) robot.target else brick.penbotTarget
    }

    private suspend fun savePython(program: Program, python: PythonTranslation) {
        val name = program.name.removeSuffix(program.language.extension)
        save(name, FileKind.PYTHON, python.python.encodeToByteArray())
    }

    private suspend fun saveImage(program: Program, image: RcxImage) =
        save(program.name.removeSuffix(program.language.extension), FileKind.RCX_IMAGE, image.toBytes())

    private suspend fun saveKit(program: Program, files: List<KitFile>) = save(
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
