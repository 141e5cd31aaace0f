package robotran.tinyvm

import robotran.language.Language
import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.config.BrickLayout
import robotran.tinyvm.config.BrickRoom
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.diagnostic.LinkError
import robotran.tinyvm.diagnostic.LinkException
import robotran.tinyvm.diagnostic.MemberUse
import robotran.tinyvm.link.ClassPath
import robotran.tinyvm.link.Linker
import robotran.tinyvm.link.MemberUses
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.natives.NativeMethods

/**
 * Links a Java program for the brick. The class files may contain arbitrary bytes.
 *
 * @param name the program's name as the pupil sees it.
 * @param program the program's class files, under arbitrary names.
 * @param library the leJOS class files by internal name, such as `java/lang/Object`.
 * @param mainClass the internal name of the main class; null for the first class with a main method.
 * @param layout what the program's image for a real brick is; null for estimates.
 */
fun linkTinyVm(
    name: String,
    program: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
    mainClass: String? = null,
    mode: TinyVmMode = TinyVmMode.BRICK,
    messages: TinyVmMessages,
    speed: TinyVmSpeed = TinyVmSpeed.BRICK,
    version: LejosVersion = LejosVersion.DEFAULT,
    layout: BrickLayout? = null,
): TinyVmResult = try {
    val files = ClassPath(program, library, messages)
    try {
        val linked = Linker(files, messages, MachineModel.of(mode), BrickRoom.of(version), layout) {
            NativeMethods.find(it) != null
        }.link(mainClass)
        TinyVmResult.Success(TinyVmProgram(name, linked, mode, messages, speed, version))
    } catch (refused: LinkException) {
        val refusal = refused.refusal
        TinyVmResult.Failure(refusal.copy(sourceFile = files.sourceFileOf(refusal.className.replace('.', '/'))))
    }
} catch (refused: LinkException) {
    TinyVmResult.Failure(refused.refusal)
} catch (_: DamagedClassFile) {
    TinyVmResult.Failure(LinkError(messages.classFileDamaged(), mainClass.orEmpty()))
}

/**
 * What the class files [program] name of the library, in the order of their code. The [program] must be one that
 * `linkTinyVm` accepts.
 */
fun memberUsesOf(program: Map<String, ByteArray>): List<MemberUse> =
    MemberUses(program, TinyVmMessages.of(Language.ENGLISH)).all()
