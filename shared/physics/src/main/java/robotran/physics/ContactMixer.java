package robotran.physics;

import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.contact.Contact;
import org.dyn4j.dynamics.contact.ContactUpdateHandler;
import org.dyn4j.world.ValueMixer;

/** The properties of a contact, as dyn4j's {@code World} mixes them from those of two fixtures. */
final class ContactMixer implements ContactUpdateHandler {
    private final ValueMixer values = ValueMixer.DEFAULT_MIXER;

    @Override
    public double getFriction(BodyFixture first, BodyFixture second) {
        return values.mixFriction(first.getFriction(), second.getFriction());
    }

    @Override
    public double getRestitution(BodyFixture first, BodyFixture second) {
        return values.mixRestitution(first.getRestitution(), second.getRestitution());
    }

    @Override
    public double getRestitutionVelocity(BodyFixture first, BodyFixture second) {
        return values.mixRestitutionVelocity(first.getRestitutionVelocity(), second.getRestitutionVelocity());
    }

    @Override
    public void begin(Contact contact) {}

    @Override
    public void persist(Contact old, Contact contact) {}

    @Override
    public void end(Contact contact) {}
}
