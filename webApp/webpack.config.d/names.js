// File names contain content hashes, so that browsers may cache them forever: see docs/hosting.md.
config.output.chunkFilename = '[name].[contenthash:16].js';
config.output.assetModuleFilename = '[name].[contenthash:16][ext]';
