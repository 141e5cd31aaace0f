package robotran.physics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.joint.FrictionJoint;
import org.dyn4j.geometry.Transform;
import org.dyn4j.geometry.Vector2;

/**
 * Takes bodies that stand still on the floor out of solver and detection until something touches them. Results stay
 * equal to the last bit: a body rests only if nothing touches it, and if the last step has changed neither its pose nor
 * its velocity nor the impulse of its friction, so the next step would not change them either. dyn4j's own detection
 * (after a time of slow motion) would change results.
 */
final class RestingBodies {
    private final List<Standing> bodies = new ArrayList<>();

    /** Adds a body on which, while nothing touches it, only the friction of the floor acts. */
    void add(RigidBody body, FrictionJoint<RigidBody> friction) {
        bodies.add(new Standing(body, friction));
    }

    /** Call after each step. */
    void update() {
        for (int i = 0; i < bodies.size(); i++) {
            Standing each = bodies.get(i);
            if (!each.body.isAtRest() && each.stood() && each.body.contacts.isEmpty()) {
                each.body.setAtRest(true);
            }
        }
    }

    private static final class Standing {
        final RigidBody body;
        private final FrictionJoint<RigidBody> friction;
        private double x;
        private double y;
        private double cosine;
        private double sine;

        Standing(RigidBody body, FrictionJoint<RigidBody> friction) {
            this.body = body;
            this.friction = friction;
        }

        /** Whether the body has stood still since the last call. */
        boolean stood() {
            Transform pose = body.getTransform();
            boolean stayed =
                x == pose.getTranslationX()
                    && y == pose.getTranslationY()
                    && cosine == pose.getCost()
                    && sine == pose.getSint();
            x = pose.getTranslationX();
            y = pose.getTranslationY();
            cosine = pose.getCost();
            sine = pose.getSint();
            return stayed
                && isZero(body.getLinearVelocity())
                && body.getAngularVelocity() == 0
                && isZero(friction.getReactionForce(1))
                && friction.getReactionTorque(1) == 0;
        }

        private static boolean isZero(Vector2 vector) {
            return vector.x == 0 && vector.y == 0;
        }
    }
}
