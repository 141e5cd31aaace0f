package robotran.tinyvm

import robotran.brick.program.DebuggableRun
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtProgram
import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.NxtCosts
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.diagnostic.LinkError
import robotran.tinyvm.diagnostic.LinkException
import robotran.tinyvm.link.ClassPath
import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.link.Linker
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.natives.nxj.NxjNatives
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.NxtPeripherals
import robotran.tinyvm.run.Peripherals

/** The result of [linkNxj]. */
sealed interface NxjResult {
    /** [program] can be loaded into a brick. */
    class Success(val program: NxjProgram) : NxjResult

    /** The program cannot run; [refusal] says why. */
    class Failure(val refusal: LinkError) : NxjResult
}

/**
 * A linked program for an NXT with leJOS NXJ; created by [linkNxj]. Immutable, so it can be started from several threads.
 */
class NxjProgram internal constructor(
    override val name: String,
    internal val linked: LinkedProgram,
    private val messages: TinyVmMessages,
    private val speed: TinyVmSpeed,
    private val mode: TinyVmMode,
    private val nativeOf: (LinkedMethod) -> NativeMethod?,
) : NxtProgram {
    override fun start(nxt: Nxt): DebuggableRun = start(NxtPeripherals(nxt))

    internal fun start(peripherals: Peripherals): NxjRun =
        NxjRun(linked, peripherals, messages, bytecodesPerStep(), mode, nativeOf)

    private fun bytecodesPerStep(): Int = when (speed) {
        TinyVmSpeed.BRICK -> NxtCosts.BYTECODES_PER_MILLISECOND / NxtCosts.STEPS_PER_MILLISECOND
        TinyVmSpeed.UNLIMITED -> NxtCosts.UNLIMITED_BYTECODES_PER_MILLISECOND / NxtCosts.STEPS_PER_MILLISECOND
    }
}

/**
 * Links a Java program for an NXT with leJOS NXJ. The class files may contain arbitrary bytes.
 *
 * @param name the program's name as the pupil sees it.
 * @param program the program's class files, under arbitrary names.
 * @param library the class files of leJOS NXJ by internal name.
 * @param mainClass the internal name of the main class; null for the first class with a main method.
 * @param mode whether an object that does not fit into an array is told to the program, as in Java, or not, as on a brick.
 */
fun linkNxj(
    name: String,
    program: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
    mainClass: String? = null,
    messages: TinyVmMessages,
    speed: TinyVmSpeed = TinyVmSpeed.BRICK,
    mode: TinyVmMode = TinyVmMode.BRICK,
): NxjResult = linkNxj(name, program, library, mainClass, messages, speed, mode, NxjNatives::find)

/** The same with other native methods, which [nativeOf] finds. */
internal fun linkNxj(
    name: String,
    program: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
    mainClass: String?,
    messages: TinyVmMessages,
    speed: TinyVmSpeed,
    mode: TinyVmMode,
    nativeOf: (LinkedMethod) -> NativeMethod?,
): NxjResult = try {
    val files = ClassPath(program, library, messages)
    try {
        val linker = Linker(files, messages, MachineModel.nxtOf(mode), null, null) { nativeOf(it) != null }
        NxjResult.Success(NxjProgram(name, linker.link(mainClass), messages, speed, mode, nativeOf))
    } catch (refused: LinkException) {
        val refusal = refused.refusal
        NxjResult.Failure(refusal.copy(sourceFile = files.sourceFileOf(refusal.className.replace('.', '/'))))
    }
} catch (refused: LinkException) {
    NxjResult.Failure(refused.refusal)
} catch (_: DamagedClassFile) {
    NxjResult.Failure(LinkError(messages.classFileDamaged(), mainClass.orEmpty()))
}
