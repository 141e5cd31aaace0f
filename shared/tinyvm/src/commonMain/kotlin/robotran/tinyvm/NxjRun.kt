package robotran.tinyvm

import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.NxtMemory
import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.messages.RunMessages
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.Peripherals
import robotran.tinyvm.run.VirtualMachine

/** One run of a program linked for an NXT. */
internal class NxjRun(
    program: LinkedProgram,
    peripherals: Peripherals,
    messages: RunMessages,
    bytecodesPerStep: Int,
    nativeOf: (LinkedMethod) -> NativeMethod?,
) : ThreadedRun(
        VirtualMachine(
            program,
            peripherals,
            MachineModel.NXT,
            messages,
            NxtMemory.HEAP_BYTES,
            NxtMemory.HEAP_BYTES,
        ),
        messages,
        bytecodesPerStep,
        nativeOf,
    )
