package robotran.programs

import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed

/**
 * How Java programs run.
 *
 * @property mode whether a program runs exactly as on the brick, or by the rules of the Java language.
 * @property speed the speed of a brick, or much faster.
 * @property version the release of leJOS whose classes a program may use in [TinyVmMode.BRICK].
 */
data class JavaSettings(
    val mode: TinyVmMode = TinyVmMode.BRICK,
    val speed: TinyVmSpeed = TinyVmSpeed.BRICK,
    val version: LejosVersion = LejosVersion.DEFAULT,
)
