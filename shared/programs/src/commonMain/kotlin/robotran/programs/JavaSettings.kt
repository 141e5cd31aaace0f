package robotran.programs

import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed

/**
 * How Java programs run.
 *
 * @property mode with all the peculiarities of a brick, or as the Java language says.
 * @property speed that of a brick, or much more.
 */
data class JavaSettings(val mode: TinyVmMode = TinyVmMode.BRICK, val speed: TinyVmSpeed = TinyVmSpeed.BRICK)
