// hint: one too many
// Measures how warm it is, shows whole degrees, and beeps when it is too warm.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;
import josx.platform.rcx.Sound;

class Thermometer {
    static final int TOO_WARM = 25; // degrees Celsius

    public static void main(String[] args) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TEMP, SensorConstants.SENSOR_MODE_DEGC);
        Thread.sleep(100); // until it has measured
        int tenths = Sensor.S1.readValue();
        int degrees = (tenths + 5) / 10; // rounded
        LCD.showNumber(degrees);
        if (degrees > TOO_WARM) {
            for (int times = 0; times < 4; times++) {
                Sound.playTone(880, 20);
                Thread.sleep(500);
            }
        }
        Thread.sleep(1000);
    }
}
