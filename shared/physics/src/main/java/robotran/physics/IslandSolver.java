package robotran.physics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.Settings;
import org.dyn4j.dynamics.TimeStep;
import org.dyn4j.dynamics.contact.ContactConstraintSolver;
import org.dyn4j.dynamics.contact.SequentialImpulses;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.Island;

/**
 * Moves all bodies by one substep. It solves the same islands, groups of movable bodies that touch each other, in the
 * same order as dyn4j's {@code ConstraintGraph}.
 */
final class IslandSolver {
    private static final Vector2 NO_GRAVITY = new Vector2();

    private final Settings settings;
    private final TimeStep step;
    private final ContactConstraintSolver<RigidBody> solver = new SequentialImpulses<>();
    private final Island<RigidBody> island = new Island<>();
    private final List<RigidBody> toVisit = new ArrayList<>();
    private long solution;

    IslandSolver(Settings settings, TimeStep step) {
        this.settings = settings;
        this.step = step;
    }

    /** Moves all movable bodies, given in a constant order. */
    void solve(List<RigidBody> movable) {
        solution++;
        for (int i = 0; i < movable.size(); i++) {
            RigidBody body = movable.get(i);
            if (body.isAtRest() || body.solution == solution) {
                continue;
            }
            if (body.contacts.isEmpty() && body.joints.isEmpty()) {
                body.integrateVelocity(NO_GRAVITY, step, settings);
                body.integratePosition(step, settings);
            } else {
                collectIsland(body);
                island.solve(solver, NO_GRAVITY, step, settings);
                island.clear();
            }
        }
    }

    private void collectIsland(RigidBody seed) {
        toVisit.add(seed);
        while (!toVisit.isEmpty()) {
            RigidBody body = toVisit.remove(toVisit.size() - 1);
            if (body.solution != solution) {
                body.solution = solution;
                body.setAtRest(false);
                island.add(body);
                addContacts(body);
                for (int i = 0; i < body.joints.size(); i++) {
                    island.add(body.joints.get(i));
                }
            }
        }
    }

    private void addContacts(RigidBody body) {
        for (int i = 0; i < body.contacts.size(); i++) {
            FixturePair contact = body.contacts.get(i);
            if (contact.solution == solution) {
                continue;
            }
            contact.solution = solution;
            island.add(contact.constraint);
            RigidBody other = contact.leafBeside(body).body;
            // Immovable bodies end an island, so that not all bodies at a wall are one.
            if (other.isDynamic() && other.solution != solution) {
                toVisit.add(other);
            }
        }
    }
}
