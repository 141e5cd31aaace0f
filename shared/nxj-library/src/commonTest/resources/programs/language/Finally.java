public class Finally {
    static int early() {
        try {
            return 1;
        } finally {
            System.out.println(10); // prints: 10
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
            System.out.println(20); // prints: 20
        }
    }

    public static void main(String[] arguments) {
        System.out.println(early()); // prints: 1
        System.out.println(overruled()); // prints: 2
        try {
            fail();
        } catch (ArrayIndexOutOfBoundsException wrong) {
            System.out.println(30); // prints: 30
        } finally {
            System.out.println(40); // prints: 40
        }
        for (int lap = 0; lap < 2; lap++) {
            try {
                if (lap == 0) continue;
                System.out.println(50); // prints: 50
            } finally {
                System.out.println(60 + lap); // prints: 60 | 61
            }
        }
    }
}
