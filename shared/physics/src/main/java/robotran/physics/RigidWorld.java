package robotran.physics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.dynamics.Settings;
import org.dyn4j.dynamics.contact.ContactConstraint;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Polygon;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;

/**
 * A dyn4j world seen from above, so without gravity. Bodies and their fixtures are known by numbers, and only numbers and arrays of
 * them go in and out, so that the same calls can be made from Kotlin on the JVM and, through WebAssembly, in the browser.
 *
 * <p>Lengths are in the caller's unit, angles in radians counter-clockwise, masses in kilograms, times in seconds. Two worlds
 * that are told the same in the same order stay equal to the last bit.
 */
public final class RigidWorld {
    /** No more fixtures than this fit on a body, since {@link #touchedFixtures} has one bit for each. */
    public static final int MAXIMUM_FIXTURES = 31;

    private final World<Body> world = new World<>();
    private final List<Body> bodies = new ArrayList<>();
    private final int stepParts;

    /**
     * @param stepSeconds the fixed time of one {@link #step}
     * @param stepParts how many equal parts a step is solved in; the more, the less deep a body gets into another before it is noticed
     * @param lengthTolerance how deep two fixtures may overlap before they are pushed apart
     * @param velocityIterations how often the solver goes over the contacts' velocities in a step
     * @param positionIterations how often it goes over their positions
     */
    public RigidWorld(double stepSeconds, int stepParts, double lengthTolerance, int velocityIterations, int positionIterations) {
        this.stepParts = stepParts;
        world.setGravity(0, 0);
        Settings settings = world.getSettings();
        settings.setStepFrequency(stepSeconds / stepParts);
        settings.setLinearTolerance(lengthTolerance);
        settings.setMaximumWarmStartDistance(2 * lengthTolerance);
        settings.setVelocityConstraintSolverIterations(velocityIterations);
        settings.setPositionConstraintSolverIterations(positionIterations);
        // It would leave a body that meets another flush exactly at its surface, to be noticed a step later and deeper inside.
        settings.setContinuousDetectionMode(ContinuousDetectionMode.NONE);
        settings.setAtRestDetectionEnabled(false);
    }

    /** Adds a body without fixtures that nothing can move, until {@link #setMass} makes it movable. Returns its number, from 0. */
    public int addBody(double x, double y, double angle) {
        Body body = new Body();
        body.rotate(angle);
        body.translate(x, y);
        body.setAtRestDetectionEnabled(false);
        body.setMass(MassType.INFINITE);
        world.addBody(body);
        bodies.add(body);
        return bodies.size() - 1;
    }

    /**
     * Adds a convex polygon to a body and returns its number on the body, from 0.
     *
     * @param corners x and y of each corner, counter-clockwise, seen from the body's origin
     * @param friction Coulomb coefficient against other fixtures
     */
    public int addPolygon(int body, double[] corners, double friction) {
        Vector2[] vertices = new Vector2[corners.length / 2];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = new Vector2(corners[2 * i], corners[2 * i + 1]);
        }
        Body owner = bodies.get(body);
        int number = owner.getFixtureCount();
        if (number >= MAXIMUM_FIXTURES) {
            throw new IllegalStateException("A body has at most " + MAXIMUM_FIXTURES + " fixtures.");
        }
        BodyFixture fixture = new BodyFixture(new Polygon(vertices));
        fixture.setFriction(friction);
        fixture.setRestitution(0);
        fixture.setUserData(number);
        owner.addFixture(fixture);
        return number;
    }

    /** Makes a body movable. {@code x} and {@code y} are its centre of mass, seen from its origin; {@code inertia} is about that centre. */
    public void setMass(int body, double x, double y, double mass, double inertia) {
        bodies.get(body).setMass(new Mass(new Vector2(x, y), mass, inertia));
    }

    /** Changes the velocity of a body at once, as a knock with this impulse at the point {@code x}, {@code y} of the world does. */
    public void applyImpulse(int body, double impulseX, double impulseY, double x, double y) {
        bodies.get(body).applyImpulse(new Vector2(impulseX, impulseY), new Vector2(x, y));
    }

    /** Lets one step of time pass. */
    public void step() {
        world.step(stepParts);
    }

    /** Where the body's origin is. */
    public double x(int body) {
        return bodies.get(body).getTransform().getTranslationX();
    }

    /** Where the body's origin is. */
    public double y(int body) {
        return bodies.get(body).getTransform().getTranslationY();
    }

    /** The cosine of the body's angle. */
    public double cosine(int body) {
        return bodies.get(body).getTransform().getCost();
    }

    /** The sine of the body's angle. */
    public double sine(int body) {
        return bodies.get(body).getTransform().getSint();
    }

    /** The velocity of the body's centre of mass along x. */
    public double velocityX(int body) {
        return bodies.get(body).getLinearVelocity().x;
    }

    /** The velocity of the body's centre of mass along y. */
    public double velocityY(int body) {
        return bodies.get(body).getLinearVelocity().y;
    }

    /** How fast the body turns, in radians a second. */
    public double angularVelocity(int body) {
        return bodies.get(body).getAngularVelocity();
    }

    /** The body's fixtures that touch another body after the last step: bit n stands for fixture n. */
    public int touchedFixtures(int body) {
        Body touched = bodies.get(body);
        int mask = 0;
        for (ContactConstraint<Body> contact : world.getContacts(touched)) {
            BodyFixture fixture = contact.getBody1() == touched ? contact.getFixture1() : contact.getFixture2();
            mask |= 1 << (Integer) fixture.getUserData();
        }
        return mask;
    }
}
