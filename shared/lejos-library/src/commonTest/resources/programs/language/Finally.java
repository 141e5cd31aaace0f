import josx.platform.rcx.LCD;

public class Finally {
    static int early() {
        try {
            return 1;
        } finally {
            LCD.showNumber(10); // shows: 10
        }
    }

    static int overruled() {
        while (true) {
            try {
                return 1;
            } finally {
                break;
            }
        }
        return 2;
    }

    static void fail() {
        try {
            int[] none = new int[0];
            none[0] = 1;
        } finally {
            LCD.showNumber(20); // shows: 20
        }
    }

    public static void main(String[] arguments) {
        LCD.showNumber(early()); // shows: 1
        LCD.showNumber(overruled()); // shows: 2
        try {
            fail();
        } catch (ArrayIndexOutOfBoundsException wrong) {
            LCD.showNumber(30); // shows: 30
        } finally {
            LCD.showNumber(40); // shows: 40
        }
        for (int lap = 0; lap < 2; lap++) {
            try {
                if (lap == 0) continue;
                LCD.showNumber(50); // shows: 50
            } finally {
                LCD.showNumber(60 + lap); // shows: 60 61
            }
        }
    }
}
