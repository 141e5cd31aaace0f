package robotran.physics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.joint.FrictionJoint;
import org.dyn4j.geometry.Transform;

/** A body with what detection and solver need to know of it, so that they look up nothing in maps. */
final class RigidBody extends Body {
    /** Its index in the world; -1 for the floor. */
    int number = -1;

    /** Identifies it in the contacts of others. */
    final int kind;

    /** Its fixtures, in their order. */
    final List<Leaf> leaves = new ArrayList<>();

    /** The pairs of fixtures through which other bodies touch it, in the order in which they were found. */
    final List<FixturePair> contacts = new ArrayList<>();

    /** Its friction on the floor. */
    final List<FrictionJoint<RigidBody>> joints = new ArrayList<>();

    final Surroundings surroundings = new Surroundings(this);

    /** Number of the last solution that has reached this body. */
    long solution;

    /** Whether its pose has changed between the last two detections. */
    boolean hasMoved;

    private double x = Double.NaN;
    private double y;
    private double cosine;
    private double sine;

    RigidBody(int kind) {
        this.kind = kind;
    }

    /** Whether it does not move in the next step if nothing touches it. */
    boolean stays() {
        return isAtRest() || !isDynamic();
    }

    /** Updates {@link #hasMoved}. */
    void notePose() {
        Transform pose = getTransform();
        hasMoved =
            x != pose.getTranslationX()
                || y != pose.getTranslationY()
                || cosine != pose.getCost()
                || sine != pose.getSint();
        x = pose.getTranslationX();
        y = pose.getTranslationY();
        cosine = pose.getCost();
        sine = pose.getSint();
    }
}
