package robotran.scene3d

import robotran.scene3d.geometry.Vector3

/** The direction to the light of the room: from the upper left, a little in front. */
internal val LIGHT = Vector3(-0.45, -0.32, 0.84).unit

/** How bright a side with this [normal] is, from a half to a little more than one; never black, as in a bright room. */
internal fun brightness(normal: Vector3, light: Vector3): Double = DARKEST + (1 + normal.dot(light)) / 2 * LIT

private const val DARKEST = 0.46
private const val LIT = 0.58
