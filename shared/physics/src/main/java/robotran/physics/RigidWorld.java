package robotran.physics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.Settings;
import org.dyn4j.dynamics.TimeStep;
import org.dyn4j.dynamics.joint.FrictionJoint;
import org.dyn4j.geometry.Circle;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Polygon;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.geometry.decompose.EarClipping;

/**
 * Rigid bodies seen from above, so without gravity. Bodies and their fixtures are identified by indices, and all
 * parameters and results are numbers and arrays of them. So Kotlin can make the same calls on the JVM and, through
 * WebAssembly, in the browser.
 *
 * <p>Shapes, bodies, contacts and the solver are dyn4j's. Its {@code World}, which decides what to compare and to
 * solve, is replaced by {@link ContactFinder} and {@link IslandSolver}: they come to the same results to the last bit,
 * without work for what stands still.
 *
 * <p>Lengths are in the caller's unit, angles in radians counter-clockwise, masses in kilograms, times in seconds. The
 * same calls in the same order give worlds that are equal to the last bit.
 */
public final class RigidWorld {
    /** Number of bits of {@link #contacts} for a body's fixtures; it does not report fixtures with higher indices. */
    public static final int FIXTURE_BITS = 16;

    /** Number of bits that follow for the kinds of the touched bodies: kinds are 0 to 14. */
    public static final int KIND_BITS = 15;

    private final RigidBody floor = new RigidBody(0);
    private final List<RigidBody> bodies = new ArrayList<>();

    /** The bodies with a finite mass, in the order of {@link #bodies}. */
    private final List<RigidBody> movable = new ArrayList<>();

    private final Settings settings = new Settings();
    private final TimeStep step = new TimeStep(settings.getStepFrequency());
    private final BoundsTree tree = new BoundsTree();
    private final ContactFinder contacts = new ContactFinder(settings, tree);
    private final IslandSolver solver = new IslandSolver(settings, step);
    private final RayCaster rays = new RayCaster(tree);
    private final RestingBodies restingBodies = new RestingBodies();
    private final double partSeconds;
    private final int stepParts;
    private boolean contactsAreOld = true;
    private Leaf met;
    private Vector2 normal;

    /**
     * @param stepSeconds the fixed time of one {@link #step}
     * @param stepParts number of equal substeps; more substeps detect a collision at a smaller penetration
     * @param lengthTolerance max overlap of two fixtures before they are pushed apart
     * @param velocityIterations velocity iterations of the contact solver per step
     * @param positionIterations position iterations of the contact solver per step
     */
    public RigidWorld(
            double stepSeconds, int stepParts, double lengthTolerance, int velocityIterations, int positionIterations) {
        this.stepParts = stepParts;
        partSeconds = stepSeconds / stepParts;
        settings.setStepFrequency(partSeconds);
        settings.setLinearTolerance(lengthTolerance);
        settings.setMaximumWarmStartDistance(2 * lengthTolerance);
        settings.setVelocityConstraintSolverIterations(velocityIterations);
        settings.setPositionConstraintSolverIterations(positionIterations);
        settings.setAtRestDetectionEnabled(false);
        floor.setMass(MassType.INFINITE);
    }

    /**
     * Adds a body without fixtures, which stays immovable until {@link #setMass} or {@link #spreadMass} is called.
     * Returns its index.
     *
     * @param kind identifies it in the {@link #contacts} of others, 0 to {@link #KIND_BITS} - 1
     */
    public int addBody(int kind, double x, double y, double angle) {
        if (kind < 0 || kind >= KIND_BITS) {
            throw new IllegalArgumentException("There is no kind " + kind + ".");
        }
        RigidBody body = new RigidBody(kind);
        body.rotate(angle);
        body.translate(x, y);
        body.setAtRestDetectionEnabled(false);
        body.setMass(MassType.INFINITE);
        body.number = bodies.size();
        bodies.add(body);
        return body.number;
    }

    /**
     * Adds a polygon to a body, as one fixture if it is convex and otherwise as several. Returns the index of its first
     * fixture on the body.
     *
     * @param corners x and y of each corner, counter-clockwise, relative to the body's origin; edges meet only in
     * corners
     * @param friction Coulomb coefficient against other fixtures
     */
    public int addPolygon(int body, double[] corners, double friction) {
        Vector2[] vertices = new Vector2[corners.length / 2];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = new Vector2(corners[2 * i], corners[2 * i + 1]);
        }
        int first = bodies.get(body).getFixtureCount();
        if (isConvex(vertices)) {
            addFixture(body, new Polygon(vertices), friction);
        } else {
            for (Convex part : new EarClipping().decompose(vertices)) {
                addFixture(body, part, friction);
            }
        }
        return first;
    }

    private static boolean isConvex(Vector2[] vertices) {
        for (int i = 0; i < vertices.length; i++) {
            Vector2 corner = vertices[i];
            Vector2 next = vertices[(i + 1) % vertices.length];
            if (corner.to(next).cross(next.to(vertices[(i + 2) % vertices.length])) < 0) {
                return false;
            }
        }
        return true;
    }

    /**
     * Adds a circle to a body and returns its index on the body. {@code x} and {@code y} are its centre, relative to
     * the body's origin.
     */
    public int addCircle(int body, double x, double y, double radius, double friction) {
        Circle circle = new Circle(radius);
        circle.translate(x, y);
        return addFixture(body, circle, friction);
    }

    private int addFixture(int body, Convex shape, double friction) {
        RigidBody owner = bodies.get(body);
        BodyFixture fixture = new BodyFixture(shape);
        fixture.setFriction(friction);
        fixture.setRestitution(0);
        owner.addFixture(fixture);
        Leaf leaf = new Leaf(owner, fixture);
        owner.leaves.add(leaf);
        tree.insert(leaf);
        contacts.add(leaf);
        return leaf.number;
    }

    /**
     * Makes a body movable. {@code x} and {@code y} are its centre of mass, relative to its origin; {@code inertia} is
     * about that centre.
     */
    public void setMass(int body, double x, double y, double mass, double inertia) {
        bodies.get(body).setMass(new Mass(new Vector2(x, y), mass, inertia));
        massHasChanged(bodies.get(body));
    }

    /** Makes a body movable, with its mass spread evenly over its fixtures. */
    public void spreadMass(int body, double mass) {
        RigidBody owner = bodies.get(body);
        double area = 0;
        for (BodyFixture fixture : owner.getFixtures()) {
            area += fixture.getShape().getArea();
        }
        for (BodyFixture fixture : owner.getFixtures()) {
            fixture.setDensity(mass / area);
        }
        owner.setMass(MassType.NORMAL);
        massHasChanged(owner);
    }

    private void massHasChanged(RigidBody body) {
        movable.clear();
        for (RigidBody each : bodies) {
            if (each.isDynamic()) {
                movable.add(each);
            }
        }
        // Pairs of immovable bodies have been left out.
        for (Leaf leaf : body.leaves) {
            contacts.add(leaf);
        }
    }

    /**
     * Adds floor friction to a movable body.
     *
     * @param force the force needed to move it, mass times length a second squared
     * @param torque the torque needed to turn it
     */
    public void addFloorFriction(int body, double force, double torque) {
        RigidBody owner = bodies.get(body);
        FrictionJoint<RigidBody> joint = new FrictionJoint<>(owner, floor, owner.getWorldCenter());
        joint.setMaximumForce(force);
        joint.setMaximumTorque(torque);
        owner.joints.add(joint);
        restingBodies.add(owner, joint);
    }

    /** Moves a body to another pose, at rest. */
    public void place(int body, double x, double y, double angle) {
        RigidBody owner = bodies.get(body);
        owner.getTransform().identity();
        owner.rotate(angle);
        owner.translate(x, y);
        owner.setLinearVelocity(0, 0);
        owner.setAngularVelocity(0);
        owner.setAtRest(false);
        contactsAreOld = true;
    }

    /** Applies an impulse to a body at the point {@code x}, {@code y} of the world; changes its velocity at once. */
    public void applyImpulse(int body, double impulseX, double impulseY, double x, double y) {
        bodies.get(body).applyImpulse(new Vector2(impulseX, impulseY), new Vector2(x, y));
    }

    /** Advances by one step. */
    public void step() {
        if (contactsAreOld) {
            contacts.find(movable);
            contactsAreOld = false;
        }
        for (int part = 0; part < stepParts; part++) {
            step.update(partSeconds);
            solver.solve(movable);
            contacts.find(movable);
        }
        restingBodies.update();
    }

    /** Whether the last step has not moved the body, and the next one will not, unless something touches it. */
    public boolean isAtRest(int body) {
        return bodies.get(body).isAtRest();
    }

    /** The x coordinate of the body's origin. */
    public double x(int body) {
        return bodies.get(body).getTransform().getTranslationX();
    }

    /** The y coordinate of the body's origin. */
    public double y(int body) {
        return bodies.get(body).getTransform().getTranslationY();
    }

    public double cosine(int body) {
        return bodies.get(body).getTransform().getCost();
    }

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

    /** In radians a second. */
    public double angularVelocity(int body) {
        return bodies.get(body).getAngularVelocity();
    }

    /**
     * The contacts of the body after the last step: bit n for its fixture n, bit {@link #FIXTURE_BITS} + k for another
     * body of kind k.
     */
    public int contacts(int body) {
        RigidBody touched = bodies.get(body);
        int mask = 0;
        for (int i = 0; i < touched.contacts.size(); i++) {
            FixturePair contact = touched.contacts.get(i);
            int fixture = contact.leafOf(touched).number;
            if (fixture < FIXTURE_BITS) {
                mask |= 1 << fixture;
            }
            mask |= 1 << (FIXTURE_BITS + contact.leafBeside(touched).body.kind);
        }
        return mask;
    }

    /**
     * The free distance from one point towards another; the whole distance if there is no obstacle. Ignores {@code
     * body}, unless it is negative, and any body that contains the first point.
     */
    public double freeDistance(int body, double fromX, double fromY, double toX, double toY) {
        Vector2 from = new Vector2(fromX, fromY);
        Vector2 way = from.to(new Vector2(toX, toY));
        double length = way.getMagnitude();
        if (length == 0) {
            return 0;
        }
        return rays.freeDistance(body < 0 ? null : bodies.get(body), from, way, length, contactsAreOld);
    }

    /**
     * The distance from one point to what is in the way towards another, like {@link #freeDistance}; negative if nothing
     * is. The next functions tell what it is, until another ray is cast.
     */
    public double ray(int body, double fromX, double fromY, double toX, double toY) {
        double distance = freeDistance(body, fromX, fromY, toX, toY);
        met = fromX == toX && fromY == toY ? null : rays.met();
        if (met == null) {
            return -1;
        }
        normal = rays.metNormal();
        return distance;
    }

    /** The body that the last {@link #ray} has met. */
    public int rayBody() {
        return met.body.number;
    }

    /** Whether that was a circle. */
    public boolean rayMetCircle() {
        return met.isRound();
    }

    /** The x component of the direction, of length 1, in which the surface looks that it has met. */
    public double rayNormalX() {
        return normal.x;
    }

    /** The y component of the same. */
    public double rayNormalY() {
        return normal.y;
    }
}
