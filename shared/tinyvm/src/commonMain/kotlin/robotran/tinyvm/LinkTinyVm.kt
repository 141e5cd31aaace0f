package robotran.tinyvm

import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.diagnostic.Refusal
import robotran.tinyvm.diagnostic.RefusalException
import robotran.tinyvm.link.ClassFiles
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
    val files = ClassFiles(program, library, messages)
    try {
        val linked = Linker(files, messages) { NativeMethods.find(it) != null }.link(mainClass)
        TinyVmResult.Ready(TinyVmProgram(name, linked, mode, messages, speed))
    } catch (refused: RefusalException) {
        val refusal = refused.refusal
        TinyVmResult.Refused(refusal.copy(sourceFile = files.sourceFileOf(refusal.className.replace('.', '/'))))
    }
} catch (refused: RefusalException) {
    TinyVmResult.Refused(refused.refusal)
} catch (_: DamagedClassFile) {
    TinyVmResult.Refused(Refusal(messages.classFileDamaged(), mainClass.orEmpty()))
}
