package robotran.nqc.generate

import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.VariableTable

/**
 * @property lines of each task and subroutine.
 * @property variables for a debugger.
 * @property unsetSensors the sensors that it compares without setting them up.
 * @property isOutOfVariables whether a variable found no place, so that the program has mistakes.
 */
internal class GeneratedProgram(
    val image: RcxImage,
    val lines: Map<ChunkId, List<NqcCodeLine>>,
    val variables: VariableTable,
    val unsetSensors: List<SensorUse.Comparison>,
    val isOutOfVariables: Boolean,
)
