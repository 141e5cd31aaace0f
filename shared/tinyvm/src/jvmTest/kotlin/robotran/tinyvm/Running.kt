package robotran.tinyvm

import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.diagnostic.LinkError
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.programs.libraryClassFiles
import kotlin.test.fail

internal class RunResult(
    val rom: RecordingRom,
    val run: DebuggableRun,
    val status: ProgramStatus,
    val failures: List<ProgramFailure>,
)

/** Links the program in [source]; fails if it is rejected. */
internal fun linked(source: String, mode: TinyVmMode = TinyVmMode.BRICK): TinyVmProgram = when (
    val result =
        linkTinyVm(
            "Program",
            JavaCompiler.compile(source),
            libraryClassFiles,
            mode = mode,
            messages = TinyVmMessages.of(Language.ENGLISH),
        )
) {
    is TinyVmResult.Success -> result.program
    is TinyVmResult.Failure -> fail(result.refusal.toString())
}

internal fun refusal(source: String): LinkError = when (
    val result =
        linkTinyVm(
            "Program",
            JavaCompiler.compile(source),
            libraryClassFiles,
            messages = TinyVmMessages.of(Language.ENGLISH),
        )
) {
    is TinyVmResult.Success -> fail("it was not refused")
    is TinyVmResult.Failure -> result.refusal
}

/** Runs [program] until it ends, for at most [milliseconds]. */
internal fun run(
    program: TinyVmProgram,
    milliseconds: Int = 20_000,
    steps: Int = 100,
    rom: RecordingRom = RecordingRom(),
): RunResult {
    val run = program.start(rom)
    val failures = mutableListOf<ProgramFailure>()
    var status: ProgramStatus = ProgramStatus.Running
    while (rom.milliseconds < milliseconds) {
        rom.milliseconds++
        val waiting = status as? ProgramStatus.Waiting
        if (waiting != null && waiting.untilMilliseconds > rom.milliseconds) continue
        status = run.resume(steps)
        if (status is ProgramStatus.ThreadFailed) failures += status.failure
        if (status == ProgramStatus.Ended || status is ProgramStatus.Failed) break
    }
    return RunResult(rom, run, status, failures)
}

/** The numbers that the main method [body] shows; [members] are further members of its class. */
internal fun shownBy(body: String, members: String = "", mode: TinyVmMode = TinyVmMode.BRICK): List<Int> =
    ran(body, members, mode).rom.shown

internal fun ran(body: String, members: String = "", mode: TinyVmMode = TinyVmMode.BRICK): RunResult =
    run(linked(program(body, members), mode))

internal fun program(body: String, members: String = ""): String = """
    import josx.platform.rcx.*;
    class Program {
        public static void main(String[] args) throws Exception {
            $body
        }
        static void show(int value) { ROM.call((short) 0x1ff2, (short) 0x3001, (short) value, (short) 0x3002); }
        static void show(boolean value) { show(value ? 1 : 0); }
        $members
    }
    """.trimIndent()
