public class Finally {
    static int early() {
        try {
            return 1;
        } finally {
            System.out.println(10);
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
            System.out.println(20);
        }
    }

    public static void main(String[] arguments) {
        System.out.println(early());
        System.out.println(overruled());
        try {
            fail();
        } catch (ArrayIndexOutOfBoundsException wrong) {
            System.out.println(30);
        } finally {
            System.out.println(40);
        }
        for (int lap = 0; lap < 2; lap++) {
            try {
                if (lap == 0) continue;
                System.out.println(50);
            } finally {
                System.out.println(60 + lap);
            }
        }
    }
}

// It prints:
// expect 10
// expect 1
// expect 2
// expect 20
// expect 30
// expect 40
// expect 60
// expect 50
// expect 61
