package robotran.physics;

import org.dyn4j.collision.BasicCollisionItem;
import org.dyn4j.collision.BasicCollisionPair;
import org.dyn4j.collision.manifold.Manifold;
import org.dyn4j.collision.narrowphase.Penetration;
import org.dyn4j.dynamics.contact.ContactConstraint;

/** Two fixtures of different bodies that are near each other. */
final class FixturePair {
    /** In the caller's unit of length; far more than a rounding error in the comparison of shapes. */
    private static final double CERTAIN_GAP = 1e-6;

    final Leaf first;
    final Leaf second;
    final Penetration penetration = new Penetration();
    final Manifold manifold = new Manifold();
    final ContactConstraint<RigidBody> constraint;

    /** Whether the fixtures did not touch when they were compared last. */
    boolean isApart;

    /** Number of the last solution that has reached this contact. */
    long solution;

    FixturePair(Leaf first, Leaf second) {
        this.first = first;
        this.second = second;
        constraint =
            new ContactConstraint<>(
                new BasicCollisionPair<>(
                    new BasicCollisionItem<>(first.body, first.fixture),
                    new BasicCollisionItem<>(second.body, second.fixture)));
        first.pairs.add(this);
        second.pairs.add(this);
    }

    /** The one that belongs to {@code body}. */
    Leaf leafOf(RigidBody body) {
        return first.body == body ? first : second;
    }

    /** The one that does not belong to {@code body}. */
    Leaf leafBeside(RigidBody body) {
        return first.body == body ? second : first;
    }

    /** Whether both bodies stay where they are, so that nothing can change between the fixtures. */
    boolean stays() {
        return first.body.stays() && second.body.stays();
    }

    /** Whether it is certain without comparing the shapes that the fixtures do not touch. */
    boolean isCertainlyApart() {
        boolean stood = !first.body.hasMoved && !second.body.hasMoved;
        return isApart && stood || first.isFarther(second, CERTAIN_GAP);
    }

    /** Forgets the pair, because the fixtures are no longer near each other. */
    void remove() {
        first.pairs.remove(this);
        second.pairs.remove(this);
    }
}
