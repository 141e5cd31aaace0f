package robotran.tinyvm

import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.diagnostic.LinkError
import robotran.tinyvm.diagnostic.LinkException
import robotran.tinyvm.link.ClassPath
import robotran.tinyvm.link.Linker
import robotran.tinyvm.messages.EnglishTinyVmMessages
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.natives.NativeMethods

/**
 * Links a Java program for the brick, whatever the bytes are.
 *
 * @param name the name a pupil knows it by.
 * @param program its class files by any names.
 * @param library the class files of leJOS by their names with slashes, such as `java/lang/Object`.
 * @param mainClass the class to begin with, its name with slashes; null for the first that has a main method.
 * @param mode how true to the brick it runs.
 * @param speed how fast it runs.
 */
fun linkTinyVm(
    name: String,
    program: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
    mainClass: String? = null,
    mode: TinyVmMode = TinyVmMode.BRICK,
    messages: TinyVmMessages = EnglishTinyVmMessages,
    speed: TinyVmSpeed = TinyVmSpeed.BRICK,
): TinyVmResult = try {
    val files = ClassPath(program, library, messages)
    try {
        val linked = Linker(files, messages) { NativeMethods.find(it) != null }.link(mainClass)
        TinyVmResult.Ready(TinyVmProgram(name, linked, mode, messages, speed))
    } catch (refused: LinkException) {
        val refusal = refused.refusal
        TinyVmResult.Rejected(refusal.copy(sourceFile = files.sourceFileOf(refusal.className.replace('.', '/'))))
    }
} catch (refused: LinkException) {
    TinyVmResult.Rejected(refused.refusal)
} catch (_: DamagedClassFile) {
    TinyVmResult.Rejected(LinkError(messages.classFileDamaged(), mainClass.orEmpty()))
}
