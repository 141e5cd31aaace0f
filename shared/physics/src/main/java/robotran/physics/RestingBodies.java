package robotran.physics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.joint.FrictionJoint;
import org.dyn4j.geometry.Transform;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.ContactCollisionData;
import org.dyn4j.world.World;
import org.dyn4j.world.listener.ContactListenerAdapter;

/**
 * Takes bodies that stand still on the floor out of dyn4j's solver until something touches them. Results stay equal to
 * the last bit: a body rests only if nothing touches it, and if the last step has changed neither its pose nor its
 * velocity nor the impulse of its friction, so the next step would not change them either. dyn4j's own detection
 * (after a time of slow motion) would change results.
 *
 * <p>A body is woken when a contact is found, which is before that contact is solved. So the solver then finds all
 * bodies in the same order as if none had rested.
 */
final class RestingBodies extends ContactListenerAdapter<Body> {
    private final World<Body> world;
    private final List<Standing> bodies = new ArrayList<>();

    RestingBodies(World<Body> world) {
        this.world = world;
        world.addContactListener(this);
    }

    /** Whether a body does not move in the next step if nothing touches it. */
    static boolean stays(Body body) {
        return body.isAtRest() || body.isStatic();
    }

    /** Adds a body on which, while nothing touches it, only the friction of the floor acts. */
    void add(Body body, FrictionJoint<Body> friction) {
        bodies.add(new Standing(body, friction));
    }

    /** Call after each step. */
    void update() {
        for (Standing each : bodies) {
            if (!each.body.isAtRest() && each.stood() && world.getContacts(each.body).isEmpty()) {
                each.body.setAtRest(true);
            }
        }
    }

    @Override
    public void collision(ContactCollisionData<Body> contact) {
        contact.getBody1().setAtRest(false);
        contact.getBody2().setAtRest(false);
    }

    private static final class Standing {
        final Body body;
        private final FrictionJoint<Body> friction;
        private double x;
        private double y;
        private double cosine;
        private double sine;

        Standing(Body body, FrictionJoint<Body> friction) {
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
