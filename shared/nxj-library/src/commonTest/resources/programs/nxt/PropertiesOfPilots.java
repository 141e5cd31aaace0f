import java.io.IOException;
import lejos.nxt.Motor;
import lejos.util.PilotProps;

public class PropertiesOfPilots {
    public static void main(String[] arguments) throws IOException {
        PilotProps properties = new PilotProps();
        properties.loadPersistentValues();
        System.out.println(properties.getProperty(PilotProps.KEY_WHEELDIAMETER, "4.96")); // expect 4.96
        System.out.println(PilotProps.getMotor("B") == Motor.B); // expect true
        properties.setProperty(PilotProps.KEY_WHEELDIAMETER, "5.6");
        properties.storePersistentValues();
        PilotProps again = new PilotProps();
        again.loadPersistentValues();
        System.out.println(again.getProperty(PilotProps.KEY_WHEELDIAMETER, "none")); // expect 5.6
    }
}
