package robotran.physics.browser;

import java.util.ArrayList;
import java.util.List;
import org.teavm.interop.Export;
import org.teavm.jso.JSExport;
import robotran.physics.RigidWorld;
import robotran.physics.Trigonometry;

/**
 * The exports of the WebAssembly module: {@link RigidWorld} and {@link Trigonometry} as plain functions, with worlds
 * identified by numbers.
 *
 * <p>{@code JSExport} makes a JavaScript function, which converts each argument, and exceptions to errors. {@code Export}
 * exports the WebAssembly function itself, which another WebAssembly module can call as fast as its own. It is for what
 * is called in each step, takes and returns only numbers, and does not throw.
 */
public final class PhysicsModule {
    private static final List<RigidWorld> worlds = new ArrayList<>();

    private PhysicsModule() {}

    /** TeaVM requires a main method; this module only has functions. */
    public static void main(String[] arguments) {}

    @JSExport
    public static int createWorld(
            double stepSeconds, int stepParts, double lengthTolerance, int velocityIterations, int positionIterations) {
        RigidWorld world =
            new RigidWorld(stepSeconds, stepParts, lengthTolerance, velocityIterations, positionIterations);
        int free = worlds.indexOf(null);
        if (free >= 0) {
            worlds.set(free, world);
            return free;
        }
        worlds.add(world);
        return worlds.size() - 1;
    }

    /** Releases a world; its number may be reused. */
    @JSExport
    public static void closeWorld(int world) {
        worlds.set(world, null);
    }

    @JSExport
    public static int addBody(int world, int kind, double x, double y, double angle) {
        return worlds.get(world).addBody(kind, x, y, angle);
    }

    @JSExport
    public static int addPolygon(int world, int body, double[] corners, double friction) {
        return worlds.get(world).addPolygon(body, corners, friction);
    }

    @JSExport
    public static void setMass(int world, int body, double x, double y, double mass, double inertia) {
        worlds.get(world).setMass(body, x, y, mass, inertia);
    }

    @JSExport
    public static int addCircle(int world, int body, double x, double y, double radius, double friction) {
        return worlds.get(world).addCircle(body, x, y, radius, friction);
    }

    @JSExport
    public static void spreadMass(int world, int body, double mass) {
        worlds.get(world).spreadMass(body, mass);
    }

    @JSExport
    public static void addFloorFriction(int world, int body, double force, double torque) {
        worlds.get(world).addFloorFriction(body, force, torque);
    }

    @JSExport
    public static void place(int world, int body, double x, double y, double angle) {
        worlds.get(world).place(body, x, y, angle);
    }

    @Export(name = "applyImpulse")
    public static void applyImpulse(int world, int body, double impulseX, double impulseY, double x, double y) {
        worlds.get(world).applyImpulse(body, impulseX, impulseY, x, y);
    }

    @Export(name = "step")
    public static void step(int world) {
        worlds.get(world).step();
    }

    @Export(name = "isAtRest")
    public static boolean isAtRest(int world, int body) {
        return worlds.get(world).isAtRest(body);
    }

    @Export(name = "x")
    public static double x(int world, int body) {
        return worlds.get(world).x(body);
    }

    @Export(name = "y")
    public static double y(int world, int body) {
        return worlds.get(world).y(body);
    }

    @Export(name = "cosine")
    public static double cosine(int world, int body) {
        return worlds.get(world).cosine(body);
    }

    @Export(name = "sine")
    public static double sine(int world, int body) {
        return worlds.get(world).sine(body);
    }

    @Export(name = "velocityX")
    public static double velocityX(int world, int body) {
        return worlds.get(world).velocityX(body);
    }

    @Export(name = "velocityY")
    public static double velocityY(int world, int body) {
        return worlds.get(world).velocityY(body);
    }

    @Export(name = "angularVelocity")
    public static double angularVelocity(int world, int body) {
        return worlds.get(world).angularVelocity(body);
    }

    @Export(name = "contacts")
    public static int contacts(int world, int body) {
        return worlds.get(world).contacts(body);
    }

    @Export(name = "freeDistance")
    public static double freeDistance(int world, int body, double fromX, double fromY, double toX, double toY) {
        return worlds.get(world).freeDistance(body, fromX, fromY, toX, toY);
    }

    @Export(name = "ray")
    public static double ray(int world, int body, double fromX, double fromY, double toX, double toY) {
        return worlds.get(world).ray(body, fromX, fromY, toX, toY);
    }

    @Export(name = "rayBody")
    public static int rayBody(int world) {
        return worlds.get(world).rayBody();
    }

    @Export(name = "rayMetCircle")
    public static boolean rayMetCircle(int world) {
        return worlds.get(world).rayMetCircle();
    }

    @Export(name = "rayNormalX")
    public static double rayNormalX(int world) {
        return worlds.get(world).rayNormalX();
    }

    @Export(name = "rayNormalY")
    public static double rayNormalY(int world) {
        return worlds.get(world).rayNormalY();
    }

    @Export(name = "sineOf")
    public static double sineOf(double angle) {
        return Trigonometry.sine(angle);
    }

    @Export(name = "cosineOf")
    public static double cosineOf(double angle) {
        return Trigonometry.cosine(angle);
    }

    @Export(name = "angleOf")
    public static double angleOf(double x, double y) {
        return Trigonometry.angle(x, y);
    }
}
