@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.simulation.physics

import kotlin.js.Promise

/**
 * The functions of `PhysicsModule.java` that build a world, as JavaScript functions; worlds, bodies and fixtures are
 * numbers. `PhysicsFunctions.kt` has the others.
 */
internal external interface PhysicsModule : JsAny {
    fun createWorld(
        stepSeconds: Double,
        stepParts: Int,
        lengthTolerance: Double,
        velocityIterations: Int,
        positionIterations: Int,
    ): Int

    fun closeWorld(world: Int)

    fun addBody(world: Int, kind: Int, x: Double, y: Double, angle: Double): Int

    fun addPolygon(world: Int, body: Int, corners: JsAny, friction: Double): Int

    fun addCircle(world: Int, body: Int, x: Double, y: Double, radius: Double, friction: Double): Int

    fun spreadMass(world: Int, body: Int, mass: Double)

    fun addFloorFriction(world: Int, body: Int, force: Double, torque: Double)

    fun place(world: Int, body: Int, x: Double, y: Double, angle: Double)

    fun setMass(world: Int, body: Int, x: Double, y: Double, mass: Double, inertia: Double)
}

/** A dynamic import, so that the module is fetched on demand, and so that bundlers find it. */
internal fun importPhysicsModule(): Promise<PhysicsModule> =
    js("import('./physics.mjs').then(module => module.loadModule())")

internal fun DoubleArray.toJsArray(): JsAny = newFloat64Array(size).also { copy ->
    forEachIndexed { place, value -> put(copy, place, value) }
}

private fun newFloat64Array(size: Int): JsAny = js("new Float64Array(size)")

private fun put(array: JsAny, place: Int, value: Double): Unit = js("{ array[place] = value; }")
