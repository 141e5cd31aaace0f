package robotran.tinyvm

import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.NxtMemory
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.messages.TinyVmRunMessages
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.Peripherals
import robotran.tinyvm.run.VirtualMachine

/** One run of a program linked for an NXT. */
internal class NxjRun(
    program: LinkedProgram,
    peripherals: Peripherals,
    messages: TinyVmRunMessages,
    bytecodesPerStep: Int,
    mode: TinyVmMode,
    nativeOf: (LinkedMethod) -> NativeMethod?,
) : ThreadedRun(
        VirtualMachine(
            program,
            peripherals,
            MachineModel.nxtOf(mode),
            messages,
            NxtMemory.HEAP_BYTES,
            NxtMemory.HEAP_BYTES,
        ),
        messages,
        bytecodesPerStep,
        nativeOf,
    )
